// The series of the map in the angle η (eta_series.h), in double: how uniform it is for every k' and cos β, on both
// sides of where the fit ends, and that the slope it reports is its own.
#define HATBOX_ISA in_double
#include "eta_series.h"

#include "support/rims.h"
#include "support/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace hatbox::test {
namespace {

using in_double::EtaSeries;
using in_double::SinCos;
using reference::SphericalEllipse;

constexpr double cos_betas[] = {1e-6, 1e-3, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99, 0.999999};

EtaSeries<double> series_of(double k_prime, double cos_beta) {
  in_double::SphericalEllipse<double> cone;
  cone.cos_beta = cos_beta;
  cone.k2 = k_prime * k_prime;
  return EtaSeries<double>(0, cone);
}

SinCos<double> sincos(double angle) { return {std::sin(angle), std::cos(angle)}; }

/// By how much the density strays from 1/Ω at the most, relative, for one k' and all heights.
double unevenness(double k_prime) {
  double largest = 0;
  for (const double cos_beta : cos_betas) {
    const SphericalEllipse ellipse = seen(k_prime, cos_beta);
    const EtaSeries<double> series = series_of(k_prime, cos_beta);
    const double whole = ellipse.solid_angle() / (ellipse.axes().a * ellipse.axes().b);
    for (double theta = 0.01; theta < 2 * std::numbers::pi; theta += 0.03) {
      const auto [shift, slope] = series(sincos(theta));
      const double uniform = whole * (1 + ellipse.rim_height(theta + shift)) / (2 * std::numbers::pi);
      largest = std::max(largest, std::abs(slope / uniform - 1));
    }
  }
  return largest;
}

TEST(EtaSeries, IsUniform) {
  const auto at_most = [](double k_prime, double bound) { EXPECT_LE(unevenness(k_prime), bound) << "k' " << k_prime; };
  for (const double k_prime : {0.78, 0.85, 0.92, 0.97, 0.99, 0.999, 1 - 1e-6, 1.0}) at_most(k_prime, 2e-6);
  for (const double k_prime : {0.5, 0.55, 0.6, 0.7}) at_most(k_prime, 1.5e-5);
  for (const double k_prime : {0.4, 0.45, 0.499999}) at_most(k_prime, 6e-5);
  at_most(0.3, 4e-4);
  at_most(0.1, 3e-2);
}

TEST(EtaSeries, SlopeIsHonest) {
  std::vector<double> errors;
  for (const double k_prime : {0.01, 0.3, 0.499, 0.501, 0.8, 0.99}) {
    for (const double cos_beta : cos_betas) {
      const EtaSeries<double> series = series_of(k_prime, cos_beta);
      for (double theta = 0.01; theta < 2 * std::numbers::pi; theta += 0.03) {
        const auto difference = [&](double h) {
          return 1 + (series(sincos(theta + h)).shift - series(sincos(theta - h)).shift) / (2 * h);
        };
        const double slope = (4 * difference(5e-4) - difference(1e-3)) / 3;
        errors.push_back(std::abs(series(sincos(theta)).slope - slope));
      }
    }
  }
  report_quantiles("slope", errors);
  EXPECT_LE(quantile(errors, 1), 1e-9);
}

}  // namespace
}  // namespace hatbox::test
