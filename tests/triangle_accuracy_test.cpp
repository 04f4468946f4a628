// How right the numbers of a triangle are: against golden values, and against the kernels' own text in double, which is
// held against the golden values too.
#define HATBOX_ISA in_double
#include "support/triangle_reference.h"

#include "golden/triangle_golden.h"
#include "support/isa_fixture.h"
#include "support/statistics.h"

#include <hatbox/hatbox.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <tuple>

namespace hatbox::test {
namespace {

using reference::Vector;

/// What float directions are apart from each other, and what the light's axes lose on the way to the world: 8 ulp.
constexpr double grain = 8 * 0x1p-24;

TEST(TriangleReference, IsGolden) {
  for (const GoldenTriangleSolidAngle& row : golden_triangle_solid_angles) {
    const kernels::TriangleLight<double> known(constants_of<double>(row.light));
    const kernels::TriangleView<double> view(known, row.point.x, row.point.y, row.point.z);
    // Doubles are 2e-9 of a float's ulp apart, and the height is a sum of several products of coordinates.
    EXPECT_NEAR(solid_angle_of(view), row.solid_angle, 1e-13 * row.solid_angle + 1e-5 * row.conditioning);
  }
  for (const GoldenTriangleDirection& row : golden_triangle_directions) {
    const auto sample = with_triangle_map(TriangleMap::spherical, row.light, row.point,
                                          [&](const auto& map) { return map.sample(row.u, row.v); });
    EXPECT_LE(angle_between(direction_of(sample), row.direction), 1e-9 * row.diameter);
    EXPECT_NEAR(sample.place.s, row.s, 1e-9);
    EXPECT_NEAR(sample.place.t, row.t, 1e-9);
  }
}

/// What rounding leaves of a number must not get lost in compilation.
TEST(TriangleConstants, LowPartsCompleteTheHighOnes) {
  for (const Pose pose : {Pose::canonical, Pose::general}) {
    for (const auto& [what, light] : triangles_in(pose)) {
      const kernels::TriangleLight<float> rounded(constants_of<float>(light));
      const auto exact = constants_of<double>(light);
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
          EXPECT_NEAR(double{rounded.axes_hi[i][j]} + double{rounded.axes_lo[i][j]}, exact.axes_hi[i][j], 1e-14);
        }
      }
    }
  }
}

class TriangleGolden : public IsaTest {};

TEST_P(TriangleGolden, SolidAngles) {
  std::vector<double> errors;
  for (const GoldenTriangleSolidAngle& row : golden_triangle_solid_angles) {
    float got = -1;
    solid_angle(row.light, {{&row.point.x, 1}, {&row.point.y, 1}, {&row.point.z, 1}}, {&got, 1});
    const double error = std::abs(got - row.solid_angle);
    EXPECT_LE(error, 2e-6 * row.solid_angle + 4 * row.conditioning)
        << "point " << row.point.x << ", " << row.point.y << ", " << row.point.z << ", solid angle " << row.solid_angle;
    errors.push_back(error / row.solid_angle);
  }
  report_quantiles("relative_error", errors);
}

TEST_P(TriangleGolden, Directions) {
  for (const GoldenTriangleDirection& row : golden_triangle_directions) {
    SampleArrays got(1);
    sample(row.light, TriangleMap::spherical, {{&row.point.x, 1}, {&row.point.y, 1}, {&row.point.z, 1}},
           {{&row.u, 1}, {&row.v, 1}}, got.view());
    EXPECT_LE(angle_between(got.direction(0), row.direction), 1e-5 * row.diameter + grain);
    EXPECT_NEAR(got.at(SampleArrays::s, 0), row.s, 1e-6);
    EXPECT_NEAR(got.at(SampleArrays::t, 0), row.t, 1e-6);
  }
}

HATBOX_FOR_EVERY_ISA(TriangleGolden);

class TriangleAccuracy : public IsaAndPoseTest {};

/// What a test knows before any kernel runs, made once for all instruction sets.
struct AccuracyCase {
  PointArrays points;
  VariateArrays variates;
  std::vector<TriangleFrom> seen;                     // for each point
  std::vector<double> solid_angles;                   // for each point
  std::vector<kernels::LightSample<double>> samples;  // k for each point
};

const AccuracyCase& accuracy_case(const NamedTriangle& triangle, Workload workload, TriangleMap map, Pose pose,
                                  std::size_t k) {
  static std::map<std::tuple<std::string, Workload, TriangleMap, Pose, std::size_t>, AccuracyCase> cases;
  AccuracyCase& result = cases[{triangle.name, workload, map, pose, k}];
  if (!result.samples.empty()) return result;
  const std::size_t n = 6000 / k;
  result.points = make_points(workload, pose, n);
  result.variates = make_variates(k * n);
  const kernels::TriangleLight<double> known(constants_of<double>(triangle.light));
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 p = result.points[i];
    result.seen.emplace_back(triangle.light, p);
    result.solid_angles.push_back(solid_angle_of(kernels::TriangleView<double>(known, p.x, p.y, p.z)));
  }
  for (std::size_t i = 0; i < k * n; ++i) {
    result.samples.push_back(with_triangle_map(map, triangle.light, result.points[i % n], [&](const auto& m) {
      return m.sample(result.variates.u[i], result.variates.v[i]);
    }));
  }
  return result;
}

/// Calls check(what, light, workload, map, case, samples) for every triangle, workload, map and number of samples.
template <class Check>
void for_every_case(Pose pose, const Check& check) {
  for (const NamedTriangle& triangle : triangles_in(pose)) {
    for (const Workload workload : all_workloads) {
      for (const TriangleMap map : all_triangle_maps) {
        for (const std::size_t k : sample_counts) {
          const AccuracyCase& given = accuracy_case(triangle, workload, map, pose, k);
          SampleArrays got(given.variates.size());
          sample(triangle.light, map, given.points.view(), given.variates.view(), got.view());
          const std::string what = triangle.name + "_" + name(workload) + "_" + name(map) + "_k" + std::to_string(k);
          SCOPED_TRACE(what);
          check(what, workload, map, given, got);
        }
      }
    }
  }
}

TEST_P(TriangleAccuracy, SamplesMatchReference) {
  for_every_case(pose(), [](const std::string& what, Workload workload, TriangleMap map, const AccuracyCase& given,
                            const SampleArrays& got) {
    std::vector<double> directions, places, coordinates, distances;
    for (std::size_t i = 0; i < got.size(); ++i) {
      ASSERT_TRUE(got.valid(i)) << i;
      const double s = got.at(SampleArrays::s, i), t = got.at(SampleArrays::t, i);
      ASSERT_LE(std::max({-s, -t, s + t - 1}), 1e-6);
      const TriangleFrom& seen = given.seen[i % given.seen.size()];
      if (map == TriangleMap::spherical && seen.ambiguous()) continue;
      const auto& want = given.samples[i];
      const double apart = angle_between(got.direction(i), direction_of(want));
      directions.push_back(std::max(apart - grain, 0.0) / seen.diameter());
      places.push_back(angle_between(seen.to(s, t), seen.to(want.place.s, want.place.t)) / seen.diameter());
      coordinates.push_back(std::max(std::abs(s - want.place.s), std::abs(t - want.place.t)));
      distances.push_back(std::abs(got.at(SampleArrays::distance, i) / want.distance - 1));
    }
    ASSERT_GT(directions.size(), got.size() * 9 / 10);
    report_quantiles("diameters_by_direction_" + what, directions);
    report_quantiles("diameters_by_place_" + what, places);
    report_quantiles("coordinates_" + what, coordinates);
    report_quantiles("distance_" + what, distances);
    const bool close = workload == Workload::w2;
    EXPECT_LE(quantile(directions, 1), close ? 1e-5 : 2e-6);
    EXPECT_LE(quantile(coordinates, 1), 1e-5);
    if (close) return;  // there the place does not tell the direction: a rounded one is 1e-7 away, the light 1e-5
    EXPECT_LE(quantile(places, 1), 2e-6);
    EXPECT_LE(quantile(distances, 1), 4e-6);
  });
}

/// The change of a triangle's solid angle with an ulp of each coordinate of point and vertices.
double conditioning(Triangle light, Vec3 point) {
  double sum = 0;
  for (Vec3* vertex : {&point, &light.a, &light.b, &light.c}) {
    for (float* x : {&vertex->x, &vertex->y, &vertex->z}) {
      const float here = *x;
      const auto at = [&](float there) {
        *x = there;
        const kernels::TriangleLight<double> known(constants_of<double>(light));
        return solid_angle_of(kernels::TriangleView<double>(known, point.x, point.y, point.z));
      };
      const double ahead = at(here + static_cast<float>(ulp(here))), behind = at(here - static_cast<float>(ulp(here)));
      *x = here;
      sum += std::abs(ahead - behind) / 2;
    }
  }
  return sum;
}

TEST_P(TriangleAccuracy, SolidAnglesMatchReference) {
  for (const NamedTriangle& triangle : triangles_in(pose())) {
    for (const Workload workload : all_workloads) {
      const AccuracyCase& given = accuracy_case(triangle, workload, TriangleMap::spherical, pose(), 1);
      std::vector<float> got(given.points.size());
      solid_angle(triangle.light, given.points.view(), got);
      std::vector<double> errors;
      for (std::size_t i = 0; i < got.size(); ++i) {
        double error = std::abs(got[i] / given.solid_angles[i] - 1);
        if (error > 2e-6) error -= 4 * conditioning(triangle.light, given.points[i]) / given.solid_angles[i];
        errors.push_back(std::max(error, 0.0));
      }
      report_quantiles("solid_angle_" + triangle.name + "_" + name(workload), errors);
      EXPECT_LE(quantile(errors, 1), 2e-6) << triangle.name << " " << name(workload);
    }
  }
}

HATBOX_FOR_EVERY_ISA_AND_POSE(TriangleAccuracy);

}  // namespace
}  // namespace hatbox::test
