#include "support/uniformity.h"

#include <algorithm>

namespace hatbox::test {

std::vector<double> variations(const Sampler& sampler, const PointArrays& points, std::size_t side) {
  const std::size_t n = points.size();
  const VariateArrays variates = make_stratified(n, side);
  SampleArrays samples(variates.size());
  std::vector<float> omega(n);
  sampler.sample(points.view(), variates.view(), samples.view(), {});
  sampler.solid_angle(points.view(), omega, {});
  std::vector<double> low(n, 1), high(n, 1);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double product = static_cast<double>(samples.at(SampleArrays::pdf, i)) * static_cast<double>(omega[i % n]);
    low[i % n] = std::min(low[i % n], product);
    high[i % n] = std::max(high[i % n], product);
  }
  for (std::size_t i = 0; i < n; ++i) high[i] -= low[i];
  return high;
}

}  // namespace hatbox::test
