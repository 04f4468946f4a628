// How right the numbers of a rectangle are: solid angle, places and directions against the paper's formulas in 33
// digits, those of two_triangles against the kernel's own text in double.
#define HATBOX_ISA in_double
#include "rectangle_area_map.h"
#include "rectangle_map.h"
#include "two_triangles_map.h"

#include "rectangle_constants.h"
#include "reference/rectangle_reference.h"
#include "support/isa_fixture.h"
#include "support/rectangles.h"
#include "support/sampler.h"
#include "support/statistics.h"
#include "support/workloads.h"

#include <hatbox/hatbox.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace hatbox::test {
namespace {

using reference::RectangleReference;
using reference::RectangleSample;

/// What a test knows before any kernel runs, made once for all instruction sets.
struct Case {
  PointArrays points;
  VariateArrays variates;
  std::vector<RectangleReference> references;  // of the points
  std::map<RectangleMap, std::vector<RectangleSample>> samples;
};

RectangleSample in_double(const Rectangle& light, const Vec3& p, float u, float v) {
  const hatbox::in_double::RectangleLight<double> known(constants_of<double>(light));
  const auto sample = hatbox::in_double::RectangleTwoTriangles<double>(known, p.x, p.y, p.z).sample(u, v);
  return {{sample.direction[0], sample.direction[1], sample.direction[2]}, sample.place.s, sample.place.t};
}

const Case& known(Workload workload, Shape shape, Pose pose, std::size_t k) {
  static std::map<std::tuple<Workload, Shape, Pose, std::size_t>, Case> cases;
  Case& result = cases[{workload, shape, pose, k}];
  if (result.samples.empty()) {
    const std::size_t n = 400 / k;
    result.points = make_points(workload, pose, n);
    result.variates = make_variates(k * n);
    const Rectangle light = rectangle_in(pose, shape);
    for (std::size_t i = 0; i < n; ++i) result.references.emplace_back(light, result.points[i]);
    for (std::size_t i = 0; i < k * n; ++i) {
      const float u = result.variates.u[i], v = result.variates.v[i];
      result.samples[RectangleMap::spherical].push_back(result.references[i % n].sample(u, v));
      result.samples[RectangleMap::two_triangles].push_back(in_double(light, result.points[i % n], u, v));
    }
  }
  return result;
}

class RectangleAccuracy : public IsaAndPoseTest {
 protected:
  /// Calls check(light, case) for every shape, workload and number of samples.
  template <class Check>
  void for_every_case(Check check) const {
    for (const Shape shape : all_shapes) {
      for (const Workload workload : all_workloads) {
        for (const std::size_t k : sample_counts) {
          const std::string what = std::string(name(workload)) + "_" + name(shape) + "_k" + std::to_string(k);
          SCOPED_TRACE(what);
          check(rectangle_in(pose(), shape), workload, known(workload, shape, pose(), k), what);
        }
      }
    }
  }
};

TEST_P(RectangleAccuracy, SolidAngle) {
  for_every_case([](const Rectangle& light, Workload, const Case& given, const std::string& what) {
    std::vector<float> got(given.points.size());
    solid_angle(light, given.points.view(), got);
    std::vector<double> errors;
    for (std::size_t i = 0; i < got.size(); ++i) {
      errors.push_back(static_cast<double>(std::abs(got[i] / given.references[i].solid_angle() - 1)));
    }
    report_quantiles("relative_" + what, errors);
    EXPECT_LE(quantile(errors, 1), 2e-6);
  });
}

TEST_P(RectangleAccuracy, DensityIsOneOverTheSolidAngle) {
  for_every_case([](const Rectangle& light, Workload, const Case& given, const std::string& what) {
    std::vector<float> solid_angles(given.points.size());
    solid_angle(light, given.points.view(), solid_angles);
    for (const auto& [map, expected] : given.samples) {
      SampleArrays got(expected.size());
      sample(light, map, given.points.view(), given.variates.view(), got.view());
      std::vector<double> errors;
      for (std::size_t i = 0; i < got.size(); ++i) {
        const double of_point = solid_angles[i % solid_angles.size()];
        errors.push_back(std::abs(of_point * static_cast<double>(got.at(SampleArrays::pdf, i)) - 1));
      }
      report_quantiles(std::string("relative_") + name(map) + "_" + what, errors);
      EXPECT_LE(quantile(errors, 1), 2e-6) << name(map);
    }
  });
}

/// How far samples are off, in units of the light's diameter as it is seen: by their direction where a float can tell,
/// by their place where the light is too narrow for that.
void expect_close(const Rectangle& light, Workload workload, const Case& given, const SampleArrays& got,
                  const std::vector<RectangleSample>& samples, double bound_in_radians, const std::string& what) {
  std::vector<double> radians, diameters, places;
  for (std::size_t i = 0; i < got.size(); ++i) {
    ASSERT_TRUE(got.valid(i));
    const RectangleReference& reference = given.references[i % given.points.size()];
    const RectangleSample& expected = samples[i];
    const float s = got.at(SampleArrays::s, i), t = got.at(SampleArrays::t, i);
    const auto direction = reference::convert<long double>(got.direction(i));
    const auto by_direction = angle_between(direction, expected.direction);
    const auto by_place = angle_between(reference.direction(s, t), expected.direction);
    radians.push_back(static_cast<double>(by_direction));
    diameters.push_back(static_cast<double>(std::min(by_direction, by_place) / reference.diameter()));
    places.push_back(static_cast<double>(std::max(std::abs(s - expected.s), std::abs(t - expected.t))));
    ASSERT_LE(outline_of(light).beyond(static_cast<double>(s), static_cast<double>(t)), 1e-5);
  }
  report_quantiles("radians_" + what, radians);
  report_quantiles("diameters_" + what, diameters);
  report_quantiles("place_" + what, places);
  EXPECT_LE(quantile(radians, 1), bound_in_radians);
  EXPECT_LE(quantile(diameters, 1), workload == Workload::w2 ? 1e-5 : 2e-6);
  if (workload != Workload::w2) {
    EXPECT_LE(quantile(places, 1), 1e-5);
  }
}

TEST_P(RectangleAccuracy, SamplesMatchReference) {
  for_every_case([](const Rectangle& light, Workload workload, const Case& given, const std::string& what) {
    for (const auto& [map, expected] : given.samples) {
      SCOPED_TRACE(name(map));
      SampleArrays got(expected.size());
      sample(light, map, given.points.view(), given.variates.view(), got.view());
      expect_close(light, workload, given, got, expected, map == RectangleMap::spherical ? 4e-7 : 1e-6,
                   std::string(name(map)) + "_" + what);
    }
  });
}

HATBOX_FOR_EVERY_ISA_AND_POSE(RectangleAccuracy);

}  // namespace
}  // namespace hatbox::test
