#include "support/statistics.h"

#include <gtest/gtest.h>
#include <boost/math/distributions/chi_squared.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <iostream>
#include <limits>
#include <numeric>

namespace hatbox::test {
namespace {

/// Maps floats to integers in their order, so that neighbours differ by one.
std::int64_t ordinal(float x) {
  const auto bits = std::bit_cast<std::int32_t>(x);
  return bits >= 0 ? bits : -static_cast<std::int64_t>(bits & 0x7fffffff);
}

}  // namespace

std::uint32_t ulp_distance(float a, float b) {
  if (std::isnan(a) || std::isnan(b)) {
    return std::isnan(a) == std::isnan(b) ? 0 : std::numeric_limits<std::uint32_t>::max();
  }
  return static_cast<std::uint32_t>(std::abs(ordinal(a) - ordinal(b)));
}

double ulp(float x) {
  const float size = std::abs(x);
  return static_cast<double>(std::nextafter(size, std::numeric_limits<float>::infinity())) - static_cast<double>(size);
}

double quantile(std::span<const double> values, double q) {
  if (values.empty()) return 0;
  std::vector<double> sorted(values.begin(), values.end());
  const double rank = std::ceil(q * static_cast<double>(sorted.size()));
  const auto nth = sorted.begin() + static_cast<std::ptrdiff_t>(std::max(rank, 1.0)) - 1;
  std::nth_element(sorted.begin(), nth, sorted.end());
  return *nth;
}

void report_quantiles(const std::string& what, std::span<const double> values) {
  std::ostringstream line;
  line.precision(3);
  line << "median " << quantile(values, 0.5) << ", 99 % " << quantile(values, 0.99) << ", 99.9 % "
       << quantile(values, 0.999) << ", max " << quantile(values, 1);
  testing::Test::RecordProperty(what, line.str());
  std::cout << "    " << what << ": " << line.str() << '\n';
}

double chi_square_p_value(std::span<const double> expected, std::span<const double> observed) {
  constexpr double smallest_cell = 5;
  std::vector<std::size_t> order(expected.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return expected[i] < expected[j]; });
  double statistic = 0, pooled_expected = 0, pooled_observed = 0;
  int cells = 0;
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    pooled_expected += expected[order[rank]];
    pooled_observed += observed[order[rank]];
    if (pooled_expected < smallest_cell && rank + 1 < order.size()) continue;
    if (pooled_expected == 0) return pooled_observed > 0 ? 0 : 1;
    statistic += (pooled_observed - pooled_expected) * (pooled_observed - pooled_expected) / pooled_expected;
    pooled_expected = pooled_observed = 0;
    ++cells;
  }
  if (cells < 2) return 1;
  return cdf(complement(boost::math::chi_squared(cells - 1), statistic));
}

double sidak_level(double level, int tests) { return -std::expm1(std::log1p(-level) / tests); }

MeanAndError mean_and_error(std::span<const double> values) {
  const auto n = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return {mean, std::sqrt(squares / (n - 1) / n)};
}

}  // namespace hatbox::test
