#include "light_choice.h"

#include "parallel.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <bit>

namespace wavefront {
namespace {

struct Scratch {
  std::vector<float> weights;
  std::vector<double> sums;
};

/// 24 bits of u would leave few to the sample of a light that is one of thousands; these go below them.
double refine(float u, std::size_t sample) {
  const auto below = static_cast<std::uint32_t>(hash(sample, std::bit_cast<std::uint32_t>(u)));
  return static_cast<double>(u) + static_cast<double>(below) * 0x1p-56;
}

/// The first of `count` sums, `stride` apart, that is above the target.
std::size_t first_above(const double* sums, std::size_t stride, std::size_t count, double target) {
  std::size_t low = 0, high = count - 1;
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    if (sums[middle * stride] > target) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return low;
}

}  // namespace

LightChoice::LightChoice(const LightTable& lights, Choice choice) : light_count_(lights.size()) {
  if (choice == Choice::solid_angle && light_count_ > 1) return;
  for (std::uint32_t light = 0; light < light_count_; ++light)
    sums_.push_back((light == 0 ? 0 : sums_.back()) +
                    (choice == Choice::power ? static_cast<double>(lights[light].power()) : 1.0));
}

void LightChoice::choose(std::size_t n, const Weigh& weigh, ConnectionQueue& samples) const {
  if (light_count_ == 1) {  // u stays what it is, to the bit
    in_parallel(samples.size(), [&](std::size_t i) {
      samples.light[i] = 0;
      samples.probability[i] = 1;
    });
    return;
  }
  const std::size_t numbers_per_item = by_point() ? light_count_ : 16;
  const std::size_t size = std::clamp<std::size_t>((std::size_t{1} << 16) / numbers_per_item, 16, 4096);
  tbb::enumerable_thread_specific<Scratch> scratch;
  tbb::parallel_for(std::size_t{0}, (n + size - 1) / size, [&](std::size_t b) {
    const Range block{b * size, std::min(size, n - b * size)};
    if (!by_point()) return choose_block(n, block, sums_, 0, samples);
    Scratch& own = scratch.local();
    sum_weights(block, weigh, own.weights, own.sums);
    choose_block(n, block, own.sums, 1, samples);
  });
}

/// The sum up to light l for item i of the block lies at [l·count + i].
void LightChoice::sum_weights(Range block, const Weigh& weigh, std::vector<float>& weights,
                              std::vector<double>& sums) const {
  weights.resize(block.count);
  sums.resize(light_count_ * block.count);
  for (std::uint32_t light = 0; light < light_count_; ++light) {
    weigh(light, block.first, weights);
    double* const sum = sums.data() + light * block.count;
    for (std::size_t i = 0; i < block.count; ++i)
      sum[i] = static_cast<double>(weights[i]) + (light == 0 ? 0 : sum[i - block.count]);
  }
}

void LightChoice::choose_block(std::size_t n, Range block, std::span<const double> sums, std::size_t sums_per_item,
                               ConnectionQueue& samples) const {
  const std::size_t stride = sums_per_item == 0 ? 1 : block.count;
  for (std::size_t i = 0; i < block.count; ++i) {
    const double* const own = sums.data() + i * sums_per_item;
    const double total = own[(light_count_ - 1) * stride];
    samples.total[block.first + i] = total;
    for (std::size_t sample = block.first + i; sample < samples.size(); sample += n) {
      const double target = refine(samples.u[sample], sample) * total;
      const std::size_t light = first_above(own, stride, light_count_, target);
      const double before = light == 0 ? 0 : own[(light - 1) * stride];
      const double weight = own[light * stride] - before;
      samples.light[sample] = static_cast<std::uint32_t>(light);
      samples.probability[sample] = weight > 0 ? static_cast<float>(weight / total) : 0;  // 0: none shines here
      samples.u[sample] = weight > 0 ? static_cast<float>((target - before) / weight) : 0;
    }
  }
}

}  // namespace wavefront
