// What multiple importance sampling stands on (Veach and Guibas 1995), for every light and map: the density of any
// direction, whoever chose it. It integrates to one over the sphere, is 0 off the light, is that of the samples, and
// the balance heuristic with it gives the irradiance that Lambert's formula has.
#include "support/all_samplers.h"
#include "support/isa_fixture.h"
#include "support/random.h"
#include "support/sphere_quadrature.h"
#include "support/statistics.h"

#include <gtest/gtest.h>
#include <boost/math/special_functions/erf.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace hatbox::test {
namespace {

using reference::Vector;

/// Around the canonical light: ordinary ones, close to it, far, beside, and where it is seen edge-on.
constexpr Vector<double> places[] = {{0.7, -0.4, 1.1}, {0.2, 0.15, 0.05}, {0.1, 0.2, -0.6},
                                     {20, -10, 15},    {2.5, 1, 0.3},     {-3, 0.5, 1e-3}};

std::string described(const Sampler& sampler, const Vector<double>& local) {
  return sampler.name + " seen from " + testing::PrintToString(std::array{local.x, local.y, local.z});
}

std::vector<float> densities(const Sampler& sampler, const Vec3& point, const DirectionArrays& directions) {
  std::vector<float> result(directions.size(), -1);
  sampler.pdf_of_direction(repeat(point, directions.size()).view(), directions.view(), result, {});
  return result;
}

class MisDensitySlow : public IsaAndPoseTest {};

TEST_P(MisDensitySlow, IntegratesToOneOverTheSphere) {
  std::vector<double> errors;
  for (const Vector<double>& local : places) {
    const Vec3 point = moved(pose(), local);
    for (const Sampler& sampler : all_samplers(pose())) {
      const SphereQuadrature sphere(sampler.outline, point);
      const std::vector<float> found = densities(sampler, point, sphere.hits);
      std::vector<float> at_place(found.size());
      sampler.pdf_of_place(repeat(point, found.size()).view(), {sphere.s, sphere.t}, at_place, {});
      double sum = 0, over_places = 0;
      for (std::size_t i = 0; i < found.size(); ++i) {
        sum += static_cast<double>(found[i]) * sphere.weights[i];
        over_places += static_cast<double>(at_place[i]) * sphere.weights[i];
      }
      // An area density goes with 1/cosine³ of a direction or 1/cosine of a place: 2^-24 of the direction, or of a
      // light's axes, are that much of the cosine.
      const double in_cosine = 0x1p-24 * length(local) / std::abs(local.z);
      const bool in_area = sampler.name.ends_with("area");
      EXPECT_NEAR(sum, 1, 1e-5 + (in_area ? 3 * in_cosine : 0)) << described(sampler, local);
      EXPECT_NEAR(over_places, 1, 1e-5 + (in_area ? in_cosine : 0)) << described(sampler, local);
      errors.push_back(std::abs(sum - 1));
    }
  }
  report_quantiles("integral", errors);
}

/// How far, in radians, a direction is from the rim, a closed chain of directions.
double from_rim(const Vector<double>& direction, const std::vector<Vector<double>>& rim) {
  double least = 2;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const Vector<double>&from = rim[i], &to = rim[(i + 1) % rim.size()];
    const Vector<double> normal = normalize(cross(from, to));
    const bool between = dot(cross(normal, from), direction) > 0 && dot(cross(to, normal), direction) > 0;
    least = std::min(least, between ? std::abs(dot(normal, direction)) : length(direction - from));
  }
  return least;
}

/// The hit test has a margin of 1e-6 rad.
TEST_P(MisDensitySlow, IsPositiveOnTheLightAndZeroOffIt) {
  constexpr double next_to_rim = 1e-5;
  for (const Vector<double>& local : places) {
    const Vec3 point = moved(pose(), local);
    for (const Sampler& sampler : all_samplers(pose())) {
      SCOPED_TRACE(described(sampler, local));
      const SphereQuadrature sphere(sampler.outline, point);
      const auto count_wrong = [&](const DirectionArrays& directions, bool hit) {
        const std::vector<float> found = densities(sampler, point, directions);
        std::size_t excused = 0;
        for (std::size_t i = 0; i < found.size(); ++i) {
          EXPECT_TRUE(std::isfinite(found[i]) && found[i] >= 0) << found[i];
          if ((found[i] > 0) == hit) continue;
          const Vector<double> direction{directions.x[i], directions.y[i], directions.z[i]};
          ASSERT_LT(from_rim(direction, sphere.rim), next_to_rim) << "hit " << hit << " density " << found[i];
          ++excused;
        }
        EXPECT_LE(excused, directions.size() / 10);
      };
      count_wrong(sphere.hits, true);
      count_wrong(sphere.misses, false);
    }
  }
}

HATBOX_FOR_EVERY_ISA_AND_POSE(MisDensitySlow);

class MisDensity : public IsaAndPoseTest {};

TEST_P(MisDensity, IsThatOfTheSamples) {
  constexpr std::size_t n = 2000;
  const VariateArrays variates = make_variates(n);
  SampleArrays samples(n);
  for (const Vector<double>& local : places) {
    const PointArrays points = repeat(moved(pose(), local), n);
    for (const Sampler& sampler : all_samplers(pose())) {
      SCOPED_TRACE(described(sampler, local));
      sampler.sample(points.view(), variates.view(), samples.view(), {});
      std::vector<float> of_direction(n), of_place(n);
      sampler.pdf_of_direction(points.view(), samples.directions(), of_direction, {});
      sampler.pdf_of_place(points.view(), samples.places(), of_place, {});
      const bool in_area = sampler.name.ends_with("area");
      for (std::size_t i = 0; i < n; ++i) {
        const double density = samples.at(SampleArrays::pdf, i);
        ASSERT_GT(density, 0) << i;
        const double cosine = std::abs(static_cast<double>(samples.at(SampleArrays::cosine, i)));
        const double hidden = in_area ? 3 * 3 * 0x1p-24 / cosine : 0;
        ASSERT_NEAR(static_cast<double>(of_direction[i]) / density, 1, 1e-5 + hidden) << i;
        ASSERT_NEAR(static_cast<double>(of_place[i]) / density, 1, 1e-5) << i;
      }
    }
  }
}

HATBOX_FOR_EVERY_ISA_AND_POSE(MisDensity);

class MisEstimateSlow : public IsaAndPoseTest {};

/// Lambert's formula for a polygon of many sides that takes the rim's place.
double irradiance(const Outline& light, const Vec3& point, const Vector<double>& patch) {
  constexpr int sides = 1 << 13;
  const auto eye = reference::convert<double>(point);
  const std::array<double, 2> middle = light.middle();
  std::vector<Vector<double>> rim;
  const auto add = [&](double angle) {
    const double r = light.to_rim(middle, angle);
    rim.push_back(light.at(middle[0] + r * std::cos(angle), middle[1] + r * std::sin(angle)) - eye);
  };
  if (light.corners.empty()) {
    for (int i = 0; i < sides; ++i) add(2 * std::numbers::pi * i / sides);
  } else {
    for (const auto& corner : light.corners) rim.push_back(light.at(corner[0], corner[1]) - eye);
  }
  double sum = 0;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const Vector<double>&from = rim[i], &to = rim[(i + 1) % rim.size()];
    sum += angle_between(from, to) * dot(patch, normalize(cross(from, to)));
  }
  return std::abs(sum) / 2;
}

/// n directions about the patch's normal, with the density cosine/π.
DirectionArrays cosine_directions(const Vector<double>& patch, std::size_t n) {
  const Vector<double> u = normalize(cross(patch, Vector<double>{0.3, 0.8, -0.5})), v = cross(patch, u);
  Random random(17);
  DirectionArrays result;
  for (std::size_t i = 0; i < n; ++i) {
    const double square = random.unit(), phi = 2 * std::numbers::pi * random.unit(), r = std::sqrt(square);
    result.push_back(r * std::cos(phi) * u + r * std::sin(phi) * v + std::sqrt(1 - square) * patch);
  }
  return result;
}

TEST_P(MisEstimateSlow, OfTheIrradianceByTheBalanceHeuristic) {
  constexpr std::size_t n = 1 << 15;
  constexpr double pi = std::numbers::pi;
  // Patches that see all of the light, so that the formula needs no clipping: above it or below, facing it.
  constexpr std::pair<Vector<double>, Vector<double>> patches[] = {
      {{0.7, -0.4, 1.1}, {-0.3, 0.2, -1}}, {{0.2, 0.15, 0.3}, {0, 0, -1}}, {{-2, 1, -1.5}, {2, -0.8, 1.7}}};
  const VariateArrays variates = make_variates(n);
  SampleArrays samples(n);
  const int tests = static_cast<int>(std::size(patches) * all_samplers(pose()).size() * 2 * wide_isas().size());
  const double sigmas = std::sqrt(2) * boost::math::erfc_inv(sidak_level(0.01, tests));
  for (const auto& [local, facing] : patches) {
    const Vec3 point = moved(pose(), local);
    const Vector<double> patch = normalize(turned(pose(), facing));
    const PointArrays points = repeat(point, n);
    const DirectionArrays scattered = cosine_directions(patch, n);
    for (const Sampler& sampler : all_samplers(pose())) {
      sampler.sample(points.view(), variates.view(), samples.view(), {});
      const std::vector<float> of_scattered = densities(sampler, point, scattered);
      std::vector<double> estimates;
      for (std::size_t i = 0; i < n; ++i) {
        const double of_light = std::max(dot(patch, samples.direction(i)), 0.0);
        const double of_patch = std::max(dot(patch, {scattered.x[i], scattered.y[i], scattered.z[i]}), 0.0);
        const double hit = of_scattered[i];
        estimates.push_back(of_light / (static_cast<double>(samples.at(SampleArrays::pdf, i)) + of_light / pi) +
                            (hit > 0 ? of_patch / (hit + of_patch / pi) : 0));
      }
      const MeanAndError estimate = mean_and_error(estimates);
      const double expected = irradiance(sampler.outline, point, patch);
      EXPECT_LE(std::abs(estimate.mean - expected), sigmas * estimate.standard_error + 1e-6 * expected)
          << described(sampler, local) << ": " << estimate.mean << " ± " << estimate.standard_error << ", not "
          << expected;
      EXPECT_LE(estimate.standard_error, 0.02 * expected) << described(sampler, local);
    }
  }
}

HATBOX_FOR_WIDE_ISAS_AND_POSE(MisEstimateSlow);

}  // namespace
}  // namespace hatbox::test
