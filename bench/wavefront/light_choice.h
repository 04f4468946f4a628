// One light for each sample, at random.
#pragma once

#include "light_table.h"
#include "names.h"
#include "queues.h"

#include <functional>

namespace wavefront {

class LightChoice {
 public:
  /// Writes the weights that one light has for the items begin … begin + out.size(). Called by many threads at a time.
  using Weigh = std::function<void(std::uint32_t light, std::size_t begin, std::span<float> out)>;

  LightChoice(const LightTable& lights, Choice choice);

  /// Whether the weights are a matter of the point; otherwise `Weigh` is not called.
  bool by_point() const { return sums_.empty(); }

  /// Chooses a light for each of the samples of n items, in proportion to the weights. `u` does so and is left
  /// stretched over the interval of what it chose, for use as a fresh variate (Shirley, Wang and Zimmerman 1996).
  ///
  /// Choosing by point takes the time of a weight for every light and item: for hundreds of lights, not for thousands.
  void choose(std::size_t n, const Weigh& weigh, ConnectionQueue& samples) const;

  /// The probability that `choose` takes a light, given its weight at that point and the sum of all.
  float probability(std::uint32_t light, float weight, double total) const {
    if (by_point()) return total > 0 ? static_cast<float>(static_cast<double>(weight) / total) : 0;
    return static_cast<float>((sums_[light] - (light == 0 ? 0 : sums_[light - 1])) / sums_.back());
  }

 private:
  void choose_block(std::size_t n, Range block, std::span<const double> sums, std::size_t sums_per_item,
                    ConnectionQueue& samples) const;
  void sum_weights(Range block, const Weigh& weigh, std::vector<float>& weights, std::vector<double>& sums) const;

  std::size_t light_count_;
  std::vector<double> sums_;  // of weights that are no matter of the point, up to and with each light's
};

}  // namespace wavefront
