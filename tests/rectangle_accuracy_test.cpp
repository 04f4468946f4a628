// How right the numbers of a rectangle are: solid angle, places and directions against the paper's formulas in 33
// digits.
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
  std::vector<RectangleSample> samples;
};

const Case& known(Workload workload, Shape shape, Pose pose, std::size_t k) {
  static std::map<std::tuple<Workload, Shape, Pose, std::size_t>, Case> cases;
  Case& result = cases[{workload, shape, pose, k}];
  if (result.samples.empty()) {
    const std::size_t n = 400 / k;
    result.points = make_points(workload, pose, n);
    result.variates = make_variates(k * n);
    for (std::size_t i = 0; i < n; ++i) result.references.emplace_back(rectangle_in(pose, shape), result.points[i]);
    for (std::size_t i = 0; i < k * n; ++i) {
      result.samples.push_back(result.references[i % n].sample(result.variates.u[i], result.variates.v[i]));
    }
  }
  return result;
}

class RectangleAccuracy : public DiskTest {
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

/// How far a sample is off, in units of the light's diameter as it is seen: by its direction where a float can tell, by
/// its place where the light is too narrow for that.
TEST_P(RectangleAccuracy, SamplesMatchReference) {
  for_every_case([](const Rectangle& light, Workload workload, const Case& given, const std::string& what) {
    SampleArrays got(given.samples.size());
    sample(light, RectangleMap::spherical, given.points.view(), given.variates.view(), got.view());
    std::vector<double> radians, diameters, places;
    for (std::size_t i = 0; i < got.size(); ++i) {
      ASSERT_TRUE(got.valid(i));
      const RectangleReference& reference = given.references[i % given.points.size()];
      const RectangleSample& expected = given.samples[i];
      const float s = got.at(SampleArrays::s, i), t = got.at(SampleArrays::t, i);
      const auto direction = reference::convert<long double>(got.direction(i));
      const auto by_direction = angle_between(direction, expected.direction);
      const auto by_place = angle_between(reference.direction(s, t), expected.direction);
      radians.push_back(static_cast<double>(by_direction));
      diameters.push_back(static_cast<double>(std::min(by_direction, by_place) / reference.diameter()));
      places.push_back(static_cast<double>(std::max(std::abs(s - expected.s), std::abs(t - expected.t))));
      ASSERT_LE(hatbox::test::outside(light, static_cast<double>(s), static_cast<double>(t)), 1e-5);
    }
    report_quantiles("radians_" + what, radians);
    report_quantiles("diameters_" + what, diameters);
    report_quantiles("place_" + what, places);
    EXPECT_LE(quantile(radians, 1), 4e-7);
    EXPECT_LE(quantile(diameters, 1), workload == Workload::w2 ? 1e-5 : 2e-6);
    if (workload != Workload::w2) {
      EXPECT_LE(quantile(places, 1), 1e-5);
    }
  });
}

HATBOX_FOR_EVERY_ISA_AND_POSE(RectangleAccuracy);

}  // namespace
}  // namespace hatbox::test
