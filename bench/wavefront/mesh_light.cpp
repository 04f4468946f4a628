#include "mesh_light.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

namespace wavefront {
namespace {

constexpr std::size_t outputs = 6;

std::array<std::span<float>, outputs> columns(const hatbox::Samples& samples) {
  return {samples.x, samples.y, samples.z, samples.distance, samples.pdf, samples.cosine};
}

/// The work on a block of points: samples are sorted by triangle, sampled triangle by triangle, and put back.
class Block {
 public:
  Block(const MeshLight& light, hatbox::TriangleMap map, Choice choice) : light_(light), map_(map), choice_(choice) {}

  /// Points `begin` … `begin + count`.
  void sample(const hatbox::Points& points, const hatbox::Variates& variates, const hatbox::Samples& out,
              std::size_t begin, std::size_t count) {
    begin_ = begin;
    count_ = count;
    if (choice_ == Choice::power) {
      sum_areas();
    } else {
      sum_solid_angles(points);
    }
    choose(points, variates);
    sample_triangles(points, out);
  }

 private:
  struct Chosen {
    std::size_t triangle;
    float probability;
    float rest;  // of the variate
  };

  /// The weights of the triangles up to and with `triangle`, from point `i` of the block.
  float& sum(std::size_t triangle, std::size_t i) {
    return choice_ == Choice::power ? sums_[triangle] : sums_[triangle * count_ + i];
  }

  void sum_areas() {
    sums_.clear();
    double area = 0;
    for (const hatbox::Triangle& triangle : light_.triangles) {
      const V3f a = to_v3f(triangle.a);
      area += 0.5 * static_cast<double>((to_v3f(triangle.b) - a).cross(to_v3f(triangle.c) - a).length());
      sums_.push_back(static_cast<float>(area));
    }
  }

  void sum_solid_angles(const hatbox::Points& points) {
    const auto part = [&](auto all) { return all.subspan(begin_, count_); };
    const hatbox::Points block{part(points.x), part(points.y), part(points.z)};
    sums_.resize(light_.triangles.size() * count_);
    for (std::size_t t = 0; t < light_.triangles.size(); ++t) {
      hatbox::solid_angle(light_.triangles[t], block, std::span(sums_).subspan(t * count_, count_));
      if (t == 0) continue;
      for (std::size_t i = 0; i < count_; ++i) sum(t, i) += sum(t - 1, i);
    }
  }

  /// The probability is that of the rounded sums, which is what samples are drawn with.
  Chosen choose_one(std::size_t i, float u) {
    std::size_t low = 0, high = light_.triangles.size() - 1;
    const float total = sum(high, i);
    const float target = u * total;
    while (low < high) {
      const std::size_t middle = (low + high) / 2;
      if (sum(middle, i) > target) {
        high = middle;
      } else {
        low = middle + 1;
      }
    }
    const float before = low == 0 ? 0 : sum(low - 1, i);
    const float weight = sum(low, i) - before;
    if (!(weight > 0)) return {low, 0, 0};  // the point is in the plane of every triangle
    return {low, weight / total, (target - before) / weight};
  }

  /// Chooses for every sample and gathers what hatbox needs, sorted by triangle: a counting sort.
  void choose(const hatbox::Points& points, const hatbox::Variates& variates) {
    const std::size_t n = points.x.size(), k = variates.u.size() / n;
    chosen_.clear();
    first_.assign(light_.triangles.size() + 1, 0);
    for (std::size_t j = 0; j < k; ++j)
      for (std::size_t i = 0; i < count_; ++i) {
        chosen_.push_back(choose_one(i, variates.u[j * n + begin_ + i]));
        ++first_[chosen_.back().triangle + 1];
      }
    for (std::size_t t = 0; t < light_.triangles.size(); ++t) first_[t + 1] += first_[t];
    std::vector<std::size_t> next = first_;
    slot_.resize(chosen_.size());
    for (auto& column : in_) column.resize(chosen_.size());
    for (std::size_t sample = 0, j = 0; j < k; ++j)
      for (std::size_t point = begin_; point < begin_ + count_; ++point, ++sample) {
        const std::size_t slot = slot_[sample] = next[chosen_[sample].triangle]++;
        in_[0][slot] = points.x[point];
        in_[1][slot] = points.y[point];
        in_[2][slot] = points.z[point];
        in_[3][slot] = chosen_[sample].rest;
        in_[4][slot] = variates.v[j * n + point];
      }
  }

  void sample_triangles(const hatbox::Points& points, const hatbox::Samples& out) {
    const auto wanted = columns(out);
    for (std::size_t c = 0; c < outputs; ++c) out_[c].resize(wanted[c].empty() ? 0 : chosen_.size());
    for (std::size_t t = 0; t < light_.triangles.size(); ++t) {
      if (first_[t] == first_[t + 1]) continue;
      const auto part = [&](auto& column) {
        return column.empty() ? std::span(column) : std::span(column).subspan(first_[t], first_[t + 1] - first_[t]);
      };
      hatbox::sample(light_.triangles[t], map_, {part(in_[0]), part(in_[1]), part(in_[2])},
                     {part(in_[3]), part(in_[4])},
                     {.x = part(out_[0]),
                      .y = part(out_[1]),
                      .z = part(out_[2]),
                      .distance = part(out_[3]),
                      .pdf = part(out_[4]),
                      .cosine = part(out_[5])});
    }
    for (std::size_t sample = 0; sample < chosen_.size(); ++sample)
      out_[4][slot_[sample]] *= chosen_[sample].probability;
    for (std::size_t c = 0; c < outputs; ++c) {
      if (wanted[c].empty()) continue;
      for (std::size_t sample = 0, first = begin_; sample < chosen_.size(); first += points.x.size())
        for (std::size_t i = 0; i < count_; ++i, ++sample) wanted[c][first + i] = out_[c][slot_[sample]];
    }
  }

  const MeshLight& light_;
  hatbox::TriangleMap map_;
  Choice choice_;

  std::size_t begin_ = 0, count_ = 0;  // the points
  std::vector<float> sums_;            // see sum
  std::vector<Chosen> chosen_;         // of each sample; sample j of point i lies at [j·count + i]
  std::vector<std::size_t> first_;     // where the samples of a triangle begin, once sorted
  std::vector<std::size_t> slot_;      // where a sample went
  std::array<std::vector<float>, 5> in_;
  std::array<std::vector<float>, outputs> out_;
};

}  // namespace

void sample_mesh(const MeshLight& light, hatbox::TriangleMap map, Choice choice, const hatbox::Points& points,
                 const hatbox::Variates& variates, const hatbox::Samples& out) {
  const std::size_t n = points.x.size();
  if (n == 0) return;
  // Large enough that triangles get whole packets, small enough that the sums of a block fit a cache.
  const std::size_t numbers_per_point = std::max(light.triangles.size(), 16 * (variates.u.size() / n));
  const std::size_t block = std::clamp<std::size_t>((std::size_t{1} << 17) / numbers_per_point, 16, 4096);
  tbb::enumerable_thread_specific<Block> work(light, map, choice);  // one a thread, for its scratch
  tbb::parallel_for(std::size_t{0}, (n + block - 1) / block, [&](std::size_t b) {
    work.local().sample(points, variates, out, b * block, std::min(block, n - b * block));
  });
}

}  // namespace wavefront
