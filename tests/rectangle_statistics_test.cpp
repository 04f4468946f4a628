// The maps as samplers: they integrate what is known, and their places are distributed as their densities say.
#include "reference/vector.h"
#include "support/isa_fixture.h"
#include "support/rectangles.h"
#include "support/statistics.h"
#include "support/workloads.h"

#include <hatbox/hatbox.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hatbox::test {
namespace {

using reference::convert;
using reference::Vector;

/// E = ½ |Σ γ n·(p × q)/|p × q|| over the sides of the polygon (Lambert 1760); the patch must see all of it.
double irradiance(const Rectangle& light, const Vec3& point, const Vector<double>& patch_normal) {
  const auto p = convert<double>(light.corner) - convert<double>(point);
  const auto u = convert<double>(light.edge_u), v = convert<double>(light.edge_v);
  const Vector<double> corners[] = {p, p + u, p + u + v, p + v};
  double sum = 0;
  for (int i = 0; i < 4; ++i) {
    const auto &from = corners[i], &to = corners[(i + 1) % 4];
    EXPECT_GT(dot(patch_normal, from), 0) << "the patch does not see all of the light";
    sum += angle_between(from, to) * dot(patch_normal, normalize(cross(from, to)));
  }
  return std::abs(sum) / 2;
}

struct Patch {
  Vector<double> point, normal;  // around the canonical light
};

constexpr Patch tilted_patches[] = {{{0, 0, 1}, {0.2, 0.1, -1}},
                                    {{0.3, -0.1, 0.05}, {0, 0, -1}},
                                    {{2, -1, 1}, {-2, 1.2, -1.5}},
                                    {{-2.5, 2, -0.4}, {2.5, -2, 0.6}},
                                    {{30, 10, 20}, {-3, -1, -1.5}}};

class RectangleIrradianceSlow : public IsaAndPoseTest {};

TEST_P(RectangleIrradianceSlow, IsLamberts) {
  constexpr std::size_t points = 1024;
  const VariateArrays variates = make_stratified(1, 1024);
  SampleArrays samples(variates.size());
  for (const Shape shape : {Shape::square, Shape::tall}) {
    const Rectangle light = rectangle_in(pose(), shape);
    for (const Patch& patch : tilted_patches) {
      const Vec3 point = moved(pose(), patch.point);
      const auto normal = normalize(turned(pose(), patch.normal));
      const double expected = irradiance(light, point, normal);
      for (const RectangleMap map : all_rectangle_maps) {
        // Next to the light even stratified area sampling has more noise than the bound.
        if (map == RectangleMap::area && (shape != Shape::square || length(patch.point) < 0.5)) continue;
        sample(light, map, repeat(point, points).view(), variates.view(), samples.view());
        double sum = 0;
        for (std::size_t i = 0; i < samples.size(); ++i) {
          ASSERT_TRUE(samples.valid(i));
          sum += dot(normal, samples.direction(i)) / static_cast<double>(samples.at(SampleArrays::pdf, i));
        }
        EXPECT_NEAR(sum / static_cast<double>(samples.size()) / expected, 1, 1e-5)
            << name(shape) << " " << name(map) << " at " << patch.point.x << ", " << patch.point.y;
      }
    }
  }
}

HATBOX_FOR_WIDE_ISAS_AND_POSE(RectangleIrradianceSlow);

class RectangleChiSquareSlow : public IsaAndPoseTest {};

/// Of a cell of the grid of places: four terms that cancel far away, where a double can afford it.
double cell_solid_angle(const Rectangle& light, const Vec3& point, std::size_t column, std::size_t row,
                        std::size_t side) {
  const auto to_corner = convert<double>(light.corner) - convert<double>(point);
  const auto u = convert<double>(light.edge_u), v = convert<double>(light.edge_v);
  const auto normal = normalize(cross(u, v));
  const double height = std::abs(dot(to_corner, normal)), x = dot(to_corner, u) / length(u),
               y = dot(to_corner, v) / length(v);
  const double step_x = length(u) / static_cast<double>(side), step_y = length(v) / static_cast<double>(side);
  const double x0 = x + static_cast<double>(column) * step_x, y0 = y + static_cast<double>(row) * step_y;
  const auto corner = [&](double a, double b) {  // its derivative by both is h/r³
    return std::atan2(a * b, height * std::sqrt(a * a + b * b + height * height));
  };
  return corner(x0 + step_x, y0 + step_y) - corner(x0, y0 + step_y) - corner(x0 + step_x, y0) + corner(x0, y0);
}

/// Cells are a grid of places; the share of each is its own solid angle, that of a smaller rectangle, over the whole.
TEST_P(RectangleChiSquareSlow, PlacesFollowTheSolidAngle) {
  constexpr Vector<double> places[] = {{0.1, 0.2, 2},   {0.2, -0.3, 0.01}, {0.6, 0.1, 0.02},
                                       {2, 1.5, -0.05}, {-0.5, 0.5, 1e-3}, {30, 100, 70}};
  constexpr std::size_t side = 12, count = 1 << 16, points = 64;
  const int tests = static_cast<int>(std::size(places) * all_shapes.size() * available_isas().size()) * 4;
  const VariateArrays variates = make_variates(count);
  SampleArrays samples(count);
  for (const Shape shape : all_shapes) {
    const Rectangle light = rectangle_in(pose(), shape);
    for (const Vector<double>& local : places) {
      const Vec3 point = moved(pose(), local);
      std::vector<double> expected;
      double whole = 0;
      for (std::size_t i = 0; i < side * side; ++i) {
        expected.push_back(cell_solid_angle(light, point, i % side, i / side, side));
        whole += expected.back();
      }
      for (double& share : expected) share *= static_cast<double>(count) / whole;
      for (const RectangleMap map : {RectangleMap::two_triangles, RectangleMap::spherical}) {
        sample(light, map, repeat(point, points).view(), variates.view(), samples.view());
        std::vector<double> observed(side * side);
        for (std::size_t i = 0; i < count; ++i) {
          const auto step = [](float x) { return std::min(static_cast<std::size_t>(x * side), side - 1); };
          ++observed[step(samples.at(SampleArrays::t, i)) * side + step(samples.at(SampleArrays::s, i))];
        }
        EXPECT_GE(chi_square_p_value(expected, observed), sidak_level(0.01, tests))
            << name(shape) << " " << name(map) << " at " << local.x << ", " << local.y << ", " << local.z;
      }
    }
  }
}

HATBOX_FOR_EVERY_ISA_AND_POSE(RectangleChiSquareSlow);

}  // namespace
}  // namespace hatbox::test
