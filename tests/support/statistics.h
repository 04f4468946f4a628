// Measures of error and tests of significance.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace hatbox::test {

/// Floats between two floats; 0 for equal ones (and for ±0), the largest number if only one is NaN.
std::uint32_t ulp_distance(float a, float b);

/// The distance from |x| to the next float away from zero.
double ulp(float x);

/// The smallest value that the share `q` of the values does not exceed. Reorders nothing; empty gives 0.
double quantile(std::span<const double> values, double q);

/// Prints median, 99 %, 99.9 % and largest, and records them in the test's XML: for what is reported, not bounded.
void report_quantiles(const std::string& what, std::span<const double> values);

/// Pearson's χ² test. Cells are pooled, smallest first, until each expects at least five. Returns the probability of
/// counts at least as uneven.
double chi_square_p_value(std::span<const double> expected, std::span<const double> observed);

/// The level for each of `tests` independent tests that keeps the chance of any false alarm at `level` (Šidák 1967).
double sidak_level(double level, int tests);

struct MeanAndError {
  double mean, standard_error;
};
MeanAndError mean_and_error(std::span<const double> values);

}  // namespace hatbox::test
