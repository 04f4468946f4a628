// The ellipse's maps as samplers: what `sample` returns, `pdf` and `invert` recognise, it lies where it is said to lie,
// it integrates what is known, and its directions are distributed as their densities say.
#include "reference/ellipse_reference.h"
#include "reference/irradiance.h"
#include "support/conditioning.h"
#include "support/ellipses.h"
#include "support/isa_fixture.h"
#include "support/opposites.h"
#include "support/statistics.h"

#include <hatbox/hatbox.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hatbox::test {
namespace {

using reference::convert;
using reference::EllipsePlace;
using reference::EtaEllipse;
using reference::Vector;

class EllipseRoundTrip : public IsaAndPoseTest {
 protected:
  /// Calls `check(light, map, points, variates, samples)` for every aspect and map, with one and three samples a point.
  template <class Check>
  void for_every_sampling(Workload workload, Check check) const {
    constexpr std::size_t samples_in_all = 6000;
    for (const double aspect : ellipse_aspects) {
      const Ellipse light = ellipse_in(pose(), aspect);
      for (const EllipseMap map : all_ellipse_maps) {
        for (const std::size_t k : sample_counts) {
          const PointArrays points = make_points(workload, pose(), samples_in_all / k);
          const VariateArrays variates = make_variates(k * points.size());
          SampleArrays samples(variates.size());
          sample(light, map, points.view(), variates.view(), samples.view());
          SCOPED_TRACE(std::string(name(workload)) + " " + name(map) + " aspect " + std::to_string(aspect) +
                       " k = " + std::to_string(k));
          check(light, map, points, variates, samples);
        }
      }
    }
  }
};

/// Where the float direction still tells (u, v): not where u wraps around, and not where the centre hides it.
bool away_from_seam(EllipseMap map, float u, float v) {
  return map != EllipseMap::radial || (u > 0.001f && u < 0.999f && v > 0.01f);
}

/// A direction off by three ulp, there and back, is off by up to twice as much on the square, in units of the narrower
/// semi-axis of what is seen.
TEST_P(EllipseRoundTrip, InvertUndoesSample) {
  constexpr double direction_error = 6e-7;
  for_every_sampling(Workload::w1, [&](const Ellipse& light, EllipseMap map, const PointArrays& points,
                                       const VariateArrays& variates, const SampleArrays& samples) {
    std::vector<float> u(samples.size()), v(samples.size());
    std::vector<double> errors;
    invert(light, map, points.view(), samples.directions(), u, v);
    for (std::size_t i = 0; i < u.size(); ++i) {
      if (!away_from_seam(map, variates.u[i], variates.v[i])) continue;
      double error = std::max(std::abs(u[i] - variates.u[i]), std::abs(v[i] - variates.v[i]));
      if (error > 1e-4) error -= direction_error / EtaEllipse(light, points[i % points.size()]).semi_axes().b;
      errors.push_back(std::max(error, 0.0));
    }
    report_quantiles(std::string("uv_error_") + name(map), errors);
    EXPECT_LE(quantile(errors, 1), 1e-4);
  });
}

TEST_P(EllipseRoundTrip, PdfOfPlaceIsThatOfSample) {
  for (const Workload workload : all_workloads) {
    for_every_sampling(workload, [&](const Ellipse& light, EllipseMap map, const PointArrays& points,
                                     const VariateArrays&, const SampleArrays& samples) {
      std::vector<float> at_place(samples.size());
      std::vector<double> errors;
      pdf(light, map, points.view(), samples.places(), at_place);
      for (std::size_t i = 0; i < at_place.size(); ++i) {
        ASSERT_GT(at_place[i], 0);
        errors.push_back(std::abs(at_place[i] / samples.at(SampleArrays::pdf, i) - 1.0));
      }
      report_quantiles(std::string("pdf_of_place_") + name(workload) + "_" + name(map), errors);
      if (workload == Workload::w1) {
        EXPECT_LE(quantile(errors, 1), 1e-5);
      }
    });
  }
}

TEST_P(EllipseRoundTrip, PdfOfDirectionIsThatOfSample) {
  for_every_sampling(Workload::w1, [&](const Ellipse& light, EllipseMap map, const PointArrays& points,
                                       const VariateArrays&, const SampleArrays& samples) {
    std::vector<float> of_direction(samples.size());
    std::vector<double> errors;
    pdf(light, map, points.view(), samples.directions(), of_direction);
    for (std::size_t i = 0; i < of_direction.size(); ++i) {
      double error = std::abs(of_direction[i] / samples.at(SampleArrays::pdf, i) - 1.0);
      if (error > 1e-5) {
        error -= 4 * pdf_conditioning(EtaEllipse(light, points[i % points.size()]), map, samples.direction(i));
      }
      errors.push_back(std::max(error, 0.0));
    }
    report_quantiles(std::string("pdf_of_direction_") + name(map), errors);
    EXPECT_LE(quantile(errors, 1), 1e-5);
  });
}

/// The way along the direction and the way over the light's axes end at the same point, which lies on the light.
TEST_P(EllipseRoundTrip, PlaceIsWhereTheDirectionEnds) {
  for (const Workload workload : {Workload::w1, Workload::w3}) {
    for_every_sampling(workload, [&](const Ellipse& light, EllipseMap, const PointArrays& points, const VariateArrays&,
                                     const SampleArrays& samples) {
      const auto axis_u = convert<double>(light.semi_axis_u), axis_v = convert<double>(light.semi_axis_v);
      const Vector<double> normal = normalize(cross(axis_u, axis_v));
      const double size = std::max(length(axis_u), length(axis_v));
      std::vector<double> gaps, unit_errors, cosine_errors;
      for (std::size_t i = 0; i < samples.size(); ++i) {
        const double s = samples.at(SampleArrays::s, i), t = samples.at(SampleArrays::t, i);
        const double distance = samples.at(SampleArrays::distance, i);
        const Vector<double> over_axes = convert<double>(light.center) + s * axis_u + t * axis_v;
        const Vector<double> direction = samples.direction(i);
        const Vector<double> along = convert<double>(points[i % points.size()]) + distance * direction;
        gaps.push_back(length(along - over_axes) / std::max<double>(distance, size));
        unit_errors.push_back(std::abs(length(direction) - 1));
        cosine_errors.push_back(std::abs(samples.at(SampleArrays::cosine, i) + dot(direction, normal)));
        ASSERT_LE(std::hypot(s, t), 1 + 1e-5);
      }
      report_quantiles(std::string("gap_") + name(workload), gaps);
      EXPECT_LE(quantile(gaps, 0.9999), 4e-6);
      EXPECT_LE(quantile(unit_errors, 1), 1e-6);
      EXPECT_LE(quantile(cosine_errors, 0.9999), 4e-6);
    });
  }
}

TEST_P(EllipseRoundTrip, OutsideIsAMiss) {
  for_every_sampling(Workload::w1, [&](const Ellipse& light, EllipseMap map, const PointArrays& points,
                                       const VariateArrays&, SampleArrays& samples) {
    expect_opposites_miss(light, map, points.view(), samples);
    std::vector<float> density(samples.size());
    for (const float radius : {0.9999f, 1.0001f}) {
      const std::vector<float> s(samples.size(), 0.6f * radius), t(samples.size(), -0.8f * radius);
      pdf(light, map, points.view(), Places{s, t}, density);
      for (const float value : density) ASSERT_EQ(value > 0, radius < 1) << "radius " << radius;
    }
  });
}

HATBOX_FOR_EVERY_ISA_AND_POSE(EllipseRoundTrip);

class EllipseIrradianceSlow : public IsaAndPoseTest {};

struct Patch {
  Vector<double> point, normal;  // around the canonical ellipse
};

/// They see the whole light, so that the integrand is smooth and stratification takes full effect.
constexpr Patch tilted_patches[] = {
    {{0.5, 0.2, 0.3}, {0, 0, -1}}, {{2, -1, 1}, {-2, 1.2, -1.5}}, {{-2.5, 2, -0.4}, {2.5, -2, 0.6}}};

TEST_P(EllipseIrradianceSlow, IsKnown) {
  constexpr std::size_t points = 1024;
  const VariateArrays variates = make_stratified(1, 1024);
  SampleArrays samples(variates.size());
  for (const double aspect : ellipse_aspects) {
    const Ellipse light = ellipse_in(pose(), aspect);
    for (const Patch& patch : tilted_patches) {
      const Vec3 point = moved(pose(), patch.point);
      const Vector<double> normal = normalize(turned(pose(), patch.normal));
      const double expected = reference::irradiance(light, point, normal);
      for (const EllipseMap map : all_ellipse_maps) {
        sample(light, map, repeat(point, points).view(), variates.view(), samples.view());
        double sum = 0;
        for (std::size_t i = 0; i < samples.size(); ++i) {
          ASSERT_TRUE(samples.valid(i));
          sum +=
              std::max(dot(normal, samples.direction(i)), 0.0) / static_cast<double>(samples.at(SampleArrays::pdf, i));
        }
        EXPECT_NEAR(sum / static_cast<double>(samples.size()) / expected, 1, map == EllipseMap::area ? 1e-4 : 1e-5)
            << name(map) << " at " << point.x << ", " << point.y << ", " << point.z << " aspect " << aspect;
      }
    }
  }
}

HATBOX_FOR_WIDE_ISAS_AND_POSE(EllipseIrradianceSlow);

/// The solid-angle maps: cells of the same solid angle, as the reference has them.
class EllipseChiSquareSlow : public IsaAndPoseTest {
 protected:
  static constexpr std::size_t side = 16;  // cells across θ and t

  static std::size_t cell(const EllipsePlace& place) {
    const double turns = place.theta / (2 * std::numbers::pi);
    const auto step = [](double x) { return std::min(static_cast<std::size_t>(x * side), side - 1); };
    return step(std::clamp(place.t, 0.0, 1.0)) * side + step(turns - std::floor(turns));
  }
};

/// A float direction cannot resolve the cells of a far or narrow light, so there the place tells the cell.
TEST_P(EllipseChiSquareSlow, DirectionsFollowTheDensity) {
  constexpr Vector<double> places[] = {{0.3, 0.1, 2}, {2, 1.5, 0.5}, {-1.1, 0.2, -0.1}, {0.4, 0.3, 1e-2}, {20, 5, -10}};
  const int tests = static_cast<int>(std::size(places) * ellipse_aspects.size() * available_isas().size()) * 4;
  constexpr std::size_t points = 64;
  const VariateArrays variates = make_variates(1 << 14);
  SampleArrays samples(variates.size());
  const std::vector<double> expected(side * side, static_cast<double>(samples.size()) / (side * side));
  for (const double aspect : ellipse_aspects) {
    const Ellipse light = ellipse_in(pose(), aspect);
    for (const Vector<double>& local : places) {
      const Vec3 point = moved(pose(), local);
      const EtaEllipse ellipse(light, point);
      for (const EllipseMap map : {EllipseMap::ld_radial, EllipseMap::radial}) {
        sample(light, map, repeat(point, points).view(), variates.view(), samples.view());
        std::vector<double> observed(side * side);
        for (std::size_t i = 0; i < samples.size(); ++i) {
          ASSERT_TRUE(samples.valid(i));
          const double s = samples.at(SampleArrays::s, i), t = samples.at(SampleArrays::t, i);
          const bool resolved = ellipse.semi_axes().b > 0.01;
          ++observed[cell(resolved ? ellipse.locate(samples.direction(i)) : ellipse.locate(s, t))];
        }
        EXPECT_GE(chi_square_p_value(expected, observed), sidak_level(0.01, tests))
            << name(map) << " at " << point.x << ", " << point.y << ", " << point.z << " aspect " << aspect;
      }
    }
  }
}

HATBOX_FOR_EVERY_ISA_AND_POSE(EllipseChiSquareSlow);

}  // namespace
}  // namespace hatbox::test
