// The map in the angle η where the rim has a kink (eta_hybrid.h), in double: against quadrature for every k', and on
// both sides of where it takes over from the series.
#define HATBOX_ISA in_double
#include "eta_hybrid.h"

#include "support/rims.h"
#include "support/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace hatbox::test {
namespace {

using in_double::EtaHybrid;
using in_double::SinCos;
using reference::SphericalEllipse;

struct Light {
  double ratio;  // less than 1, of an ellipse
};

EtaHybrid<double> map_of(const SphericalEllipse& ellipse, double ratio = 0.5) {
  const auto [a, b, cos_alpha, cos_beta] = ellipse.axes();
  in_double::SphericalEllipse<double> cone;
  cone.valid = true;
  cone.a = a;
  cone.b = b;
  cone.inverse_ab = 1 / (a * b);
  cone.cos_beta = cos_beta;
  cone.k2 = (cos_alpha / cos_beta) * (cos_alpha / cos_beta);
  return EtaHybrid<double>(Light{ratio}, cone);
}

SinCos<double> sincos(double angle) { return {std::sin(angle), std::cos(angle)}; }

constexpr double k_primes[] = {1e-6, 1e-4, 1e-3, 0.01, 0.03, 0.1, 0.2, 0.3, 0.399};
constexpr double cos_betas[] = {1e-6, 0.01, 0.3, 0.7, 0.9, 0.999, 0.999999};

/// Calls check(ellipse, map, θ) for many rims with kinks, and angles all around that gather at the kinks.
template <class Check>
void for_every_kink(Check check) {
  for (const double k_prime : k_primes) {
    for (const double cos_beta : cos_betas) {
      const SphericalEllipse ellipse = seen(k_prime, cos_beta);
      const EtaHybrid<double> map = map_of(ellipse);
      SCOPED_TRACE("k' " + std::to_string(k_prime) + ", cos β " + std::to_string(cos_beta));
      for (const double end : {0.0, std::numbers::pi}) {
        for (double off = std::numbers::pi / 2; off > 1e-7; off /= 1.7) {
          for (const double theta : {end - off, end + off}) check(ellipse, map, theta);
        }
      }
    }
  }
}

TEST(EtaHybrid, IsTheReferencesMap) {
  std::vector<double> errors, slope_errors;
  for_every_kink([&](const SphericalEllipse& ellipse, const EtaHybrid<double>& map, double theta) {
    const auto [shift, slope] = map(sincos(theta));
    int iterations = 0;
    const double eta = ellipse.eta(theta, iterations);
    const double whole = ellipse.solid_angle() / (ellipse.axes().a * ellipse.axes().b);
    errors.push_back(std::abs(theta + shift - eta));
    slope_errors.push_back(std::abs(slope / (whole * (1 + ellipse.rim_height(eta)) / (2 * std::numbers::pi)) - 1));
  });
  report_quantiles("eta", errors);
  report_quantiles("slope", slope_errors);
  EXPECT_LE(quantile(errors, 1), 4e-9);
  EXPECT_LE(quantile(slope_errors, 1), 4e-9);
}

/// The slope it reports is that of what it computes.
TEST(EtaHybrid, SlopeIsHonest) {
  std::vector<double> errors;
  for_every_kink([&](const SphericalEllipse&, const EtaHybrid<double>& map, double theta) {
    const double to_kink = std::abs(std::remainder(theta, std::numbers::pi));
    const double step = 1e-3 * to_kink;
    const auto difference = [&](double h) {
      return 1 + (map(sincos(theta + h)).shift - map(sincos(theta - h)).shift) / (2 * h);
    };
    const double slope = (4 * difference(step / 2) - difference(step)) / 3;
    if (to_kink > 1e-5) errors.push_back(std::abs(map(sincos(theta)).slope / slope - 1));  // closer, digits run out
  });
  report_quantiles("slope", errors);
  EXPECT_LE(quantile(errors, 1), 2e-7);
}

TEST(EtaHybrid, FindsItsWayBack) {
  std::vector<double> errors;
  for_every_kink([&](const SphericalEllipse&, const EtaHybrid<double>& map, double theta) {
    const auto [shift, slope] = map(sincos(theta));
    const auto [angle, same_slope] = map.uniform_angle(sincos(theta + shift));
    errors.push_back(std::hypot(angle.sin - std::sin(theta), angle.cos - std::cos(theta)));
    EXPECT_NEAR(same_slope / slope, 1, 1e-12);
  });
  report_quantiles("theta", errors);
  EXPECT_LE(quantile(errors, 1), 4e-9);
}

/// Where the series is good enough, and for circles, the map is the series.
TEST(EtaHybrid, LeavesTheRestToTheSeries) {
  for (const double theta : {0.1, 0.5, 1.2, 2.0, 3.0, 4.5, 6.0}) {
    const SinCos<double> angle = sincos(theta);
    for (const double k_prime : {0.3, 0.399, 0.401, 0.9}) {
      const SphericalEllipse ellipse = seen(k_prime, 0.999);
      const double hybrid = map_of(ellipse)(angle).shift, series = map_of(ellipse, 1)(angle).shift;
      EXPECT_EQ(hybrid == series, k_prime > 0.4) << k_prime << " at " << theta;
      EXPECT_NEAR(hybrid, series, 3e-5) << k_prime << " at " << theta;
    }
  }
}

}  // namespace
}  // namespace hatbox::test
