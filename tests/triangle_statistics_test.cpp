// The maps of a triangle as samplers: they integrate what is known, and are distributed as their densities say.
#define HATBOX_ISA in_double
#include "support/triangle_reference.h"

#include "support/isa_fixture.h"
#include "support/statistics.h"

#include <hatbox/hatbox.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hatbox::test {
namespace {

using reference::Vector;

/// The irradiance of a patch that sees the whole triangle, of unit radiance (Lambert 1760).
double irradiance(const TriangleFrom& seen, const Vector<double>& patch) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector<double> p = seen.vertices[(i + 1) % 3], q = seen.vertices[(i + 2) % 3];
    sum += seen.sides[i] * dot(patch, normalize(cross(p, q)));
  }
  return std::abs(sum) / 2;
}

struct Patch {
  Vector<double> point, normal;  // around the canonical disk
};

/// They see the whole light, so that the integrand is smooth and stratification takes full effect.
constexpr Patch tilted_patches[] = {{{0, 0, 1}, {0.2, 0.1, -1}},
                                    {{0.5, 0.2, 0.3}, {0, 0, -1}},
                                    {{2, -1, 1}, {-2, 1.2, -1.5}},
                                    {{-2.5, 2, -0.4}, {2.5, -2, 0.6}},
                                    {{30, 10, 20}, {-3, -1, -1.5}}};

class TriangleIrradianceSlow : public IsaAndPoseTest {};

TEST_P(TriangleIrradianceSlow, IsKnown) {
  constexpr std::size_t points = 1024;
  const VariateArrays variates = make_stratified(1, 1024);
  SampleArrays samples(variates.size());
  for (const auto& [what, light] : triangles_in(pose())) {
    for (const Patch& patch : tilted_patches) {
      const Vec3 point = moved(pose(), patch.point);
      const Vector<double> normal = normalize(turned(pose(), patch.normal));
      const double expected = irradiance(TriangleFrom(light, point), normal);
      for (const TriangleMap map : all_triangle_maps) {
        sample(light, map, repeat(point, points).view(), variates.view(), samples.view());
        double sum = 0;
        for (std::size_t i = 0; i < samples.size(); ++i) {
          sum +=
              std::max(dot(normal, samples.direction(i)), 0.0) / static_cast<double>(samples.at(SampleArrays::pdf, i));
        }
        EXPECT_NEAR(sum / static_cast<double>(samples.size()) / expected, 1, 1e-5)
            << what << " " << name(map) << " at " << patch.point.x << ", " << patch.point.y << ", " << patch.point.z;
      }
    }
  }
}

HATBOX_FOR_WIDE_ISAS_AND_POSE(TriangleIrradianceSlow);

class TriangleChiSquareSlow : public IsaAndPoseTest {
 protected:
  static constexpr std::size_t side = 8;  // the triangle is cut into side² alike

  /// The cell of a place: which of the rhombi, and on which side of its diagonal.
  static std::size_t cell(double s, double t) {
    const auto step = [](double x) { return std::min(static_cast<std::size_t>(std::max(x, 0.0) * side), side - 1); };
    const std::size_t i = step(s), j = step(t);
    const bool upper = s * side - static_cast<double>(i) + t * side - static_cast<double>(j) > 1;
    return 2 * (j * side + i) + upper;
  }

  /// The share of each cell in the solid angle or the area; 0 for those beyond the longest side.
  static std::vector<double> shares(const Triangle& light, const Vec3& point, TriangleMap map) {
    std::vector<double> result(2 * side * side);
    const TriangleFrom whole(light, point);
    for (std::size_t c = 0; c < result.size(); ++c) {
      const double i = static_cast<double>(c / 2 % side), j = static_cast<double>(c / 2 / side);
      const bool upper = c % 2;
      if (i + j + upper >= side) continue;
      TriangleFrom part = whole;
      const double far = upper ? 1 : 0;
      part.vertices = {whole.to((i + far) / side, (j + far) / side), whole.to((i + 1) / side, j / side),
                       whole.to(i / side, (j + 1) / side)};
      result[c] = map == TriangleMap::area ? 1.0 / (side * side) : part.solid_angle() / whole.solid_angle();
    }
    return result;
  }
};

TEST_P(TriangleChiSquareSlow, PlacesFollowTheDensity) {
  constexpr Vector<double> places[] = {{0.3, 0.1, 2}, {2, 1.5, 0.5}, {-1.1, 0.2, -0.1}, {0, -0.2, 1e-2}, {20, 5, -10}};
  const int tests = static_cast<int>(std::size(places) * 3 * all_triangle_maps.size() * available_isas().size()) * 2;
  const VariateArrays variates = make_variates(1 << 15);
  SampleArrays samples(variates.size());
  for (const auto& [what, light] : triangles_in(pose())) {
    for (const Vector<double>& local : places) {
      const Vec3 point = moved(pose(), local);
      for (const TriangleMap map : all_triangle_maps) {
        sample(light, map, repeat(point, 64).view(), variates.view(), samples.view());
        std::vector<double> expected = shares(light, point, map), observed(expected.size());
        for (double& share : expected) share *= static_cast<double>(samples.size());
        for (std::size_t i = 0; i < samples.size(); ++i) {
          ++observed[cell(samples.at(SampleArrays::s, i), samples.at(SampleArrays::t, i))];
        }
        EXPECT_GE(chi_square_p_value(expected, observed), sidak_level(0.01, tests))
            << what << " " << name(map) << " at " << local.x << ", " << local.y << ", " << local.z;
      }
    }
  }
}

HATBOX_FOR_EVERY_ISA_AND_POSE(TriangleChiSquareSlow);

}  // namespace
}  // namespace hatbox::test
