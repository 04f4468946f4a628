// Shading points where formulas for rectangles break: over and beside edges and corners and on their lines, a hair
// above the light, where a corner's angle is 180° or 0°, and far out; with the variates' extremes.
#include "reference/rectangle_reference.h"
#include "support/isa_fixture.h"
#include "support/random.h"
#include "support/rectangles.h"
#include "support/sampler.h"
#include "support/workloads.h"

#include <hatbox/hatbox.h>

#include <gtest/gtest.h>

#include <cmath>

namespace hatbox::test {
namespace {

constexpr float last_below_one = 0x1.fffffep-1f;
constexpr float variates_of_interest[] = {0.0f, 0x1p-24f, 0.25f, 0.5f, 0.75f, last_below_one, 1.0f};
constexpr float coordinates[] = {0,          0x1p-60f, 0.25f, 0x1.fffffep-2f, 0.5f, 0x1.000002p-1f, -0.5f,
                                 -0.500001f, -0.75f,   2,     -1e3f,          1e6f, 1e12f};

/// Around the canonical rectangles, whose edges and corners floats hit exactly.
PointArrays hard_points(float height) {
  PointArrays points;
  for (const float x : coordinates) {
    for (const float y : coordinates) points.push_back({x, y, height});
  }
  return points;
}

class RectangleHardPlaces : public IsaTest {};

TEST_P(RectangleHardPlaces, SamplesAreSane) {
  for (const Shape shape : all_shapes) {
    const Rectangle light = rectangle_in(Pose::canonical, shape);
    for (const float height : {0.0f, 1e-38f, -1e-30f, 1e-20f, 1e-7f, -1e-3f, 1.0f, 1e9f, -1e18f, 1e38f}) {
      const PointArrays points = hard_points(height);
      for (const RectangleMap map : all_rectangle_maps) {
        for (const float u : variates_of_interest) {
          for (const float v : variates_of_interest) {
            const std::vector<float> all_u(points.size(), u), all_v(points.size(), v);
            SampleArrays samples(points.size());
            sample(light, map, points.view(), {all_u, all_v}, samples.view());
            for (std::size_t i = 0; i < points.size(); ++i) {
              for (const auto& column : samples.columns) ASSERT_TRUE(std::isfinite(column[i]));
              ASSERT_GE(samples.at(SampleArrays::pdf, i), 0);
              if (!samples.valid(i)) {
                for (const auto& column : samples.columns) ASSERT_EQ(column[i], 0);
                continue;
              }
              ASSERT_NE(height, 0);
              ASSERT_NEAR(length(samples.direction(i)), 1, 1e-6)
                  << name(shape) << " " << name(map) << " from " << points.x[i] << ", " << points.y[i] << ", " << height
                  << " at " << u << ", " << v;
              const double s = samples.at(SampleArrays::s, i), t = samples.at(SampleArrays::t, i);
              ASSERT_LE(outline_of(light).beyond(s, t), 1e-5) << points.x[i] << ", " << points.y[i];
            }
          }
        }
      }
    }
  }
}

/// A corner at the origin, which floats come as near to as they like.
TEST_P(RectangleHardPlaces, DirectionsAreOfUnitLengthNextToACorner) {
  const Rectangle light{{0, 0, 0}, {1, 0, 0}, {0, 0.7f, 0}};
  Random random(1);
  const auto coordinate = [&] {
    const auto size = static_cast<float>(random.log_uniform(1e-30, 10));
    return random.unit() < 0.5 ? -size : size;
  };
  PointArrays points;
  for (int i = 0; i < 4096; ++i) points.push_back({coordinate(), coordinate(), coordinate()});
  const VariateArrays variates = make_variates(points.size());
  for (const RectangleMap map : all_rectangle_maps) {
    SampleArrays samples(points.size());
    sample(light, map, points.view(), variates.view(), samples.view());
    std::size_t valid = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!samples.valid(i)) continue;
      ++valid;
      ASSERT_NEAR(length(samples.direction(i)), 1, 1e-6)
          << name(map) << " from " << points.x[i] << ", " << points.y[i] << ", " << points.z[i];
    }
    EXPECT_GT(valid, points.size() / 2) << name(map);
  }
}

TEST_P(RectangleHardPlaces, SolidAngleIsRight) {
  for (const Shape shape : all_shapes) {
    const Rectangle light = rectangle_in(Pose::canonical, shape);
    for (const float height : {1e-7f, 1e-3f, 1.0f, 1e4f}) {
      PointArrays points;
      for (const float x : coordinates) {
        for (const float y : coordinates) {
          if (std::abs(x) <= 1e3f && std::abs(y) <= 1e3f) points.push_back({x, y, height});
        }
      }
      std::vector<float> got(points.size());
      solid_angle(light, points.view(), got);
      for (std::size_t i = 0; i < got.size(); ++i) {
        const auto expected = static_cast<double>(reference::RectangleReference(light, points[i]).solid_angle());
        ASSERT_NEAR(static_cast<double>(got[i]) / expected, 1, 2e-6)
            << name(shape) << " from " << points.x[i] << ", " << points.y[i] << ", " << height;
      }
    }
  }
}

/// No threshold below which a light seen from beside it disappears or keeps its size.
TEST_P(RectangleHardPlaces, BesideTheLightItsSolidAngleGoesLikeTheHeight) {
  const Rectangle light = rectangle_in(Pose::canonical, Shape::square);
  for (const auto& [x, y] : {std::pair{0.75f, 0.0f}, std::pair{0.75f, 0.5f}, std::pair{-3.0f, 7.0f}}) {
    PointArrays points;
    for (const float height : {1e-8f, 1e-16f, 1e-19f, 1e-24f, -1e-30f}) points.push_back({x, y, height});
    std::vector<float> got(points.size());
    solid_angle(light, points.view(), got);
    for (std::size_t i = 0; i < got.size(); ++i) {
      EXPECT_NEAR(got[i] / std::abs(points.z[i]) / (got[0] / points.z[0]), 1, 2e-6) << points.z[i];
    }
  }
}

/// However close to the light's plane: there the maps do not go by the height itself.
TEST_P(RectangleHardPlaces, DensityIsOneOverTheSolidAngle) {
  const Rectangle light = rectangle_in(Pose::canonical, Shape::square);
  for (const float height : {1e-8f, 1e-16f, 1e-19f, 1e-24f, -1e-30f, 1e-33f}) {
    PointArrays points;
    for (const auto& [x, y] : {std::pair{0.75f, 0.0f}, std::pair{0.75f, 0.5f}, std::pair{-3.0f, 7.0f},
                               std::pair{0.2f, -3.0f}, std::pair{0.2f, 0.3f}, std::pair{-0.2f, 0.1f}}) {
      points.push_back({x, y, height});
    }
    const VariateArrays variates = make_variates(points.size());
    std::vector<float> solid_angles(points.size());
    solid_angle(light, points.view(), solid_angles);
    for (const RectangleMap map : {RectangleMap::two_triangles, RectangleMap::spherical}) {
      SampleArrays samples(points.size());
      sample(light, map, points.view(), variates.view(), samples.view());
      for (std::size_t i = 0; i < points.size(); ++i) {
        const double density = samples.at(SampleArrays::pdf, i);
        EXPECT_NEAR(density * static_cast<double>(solid_angles[i]), 1, 2e-6)
            << name(map) << " from " << points.x[i] << ", " << points.y[i] << ", " << height;
      }
    }
  }
}

TEST_P(RectangleHardPlaces, OverTheLightItIsHalfTheSphere) {
  constexpr double pi = 3.14159265358979323846;
  const Rectangle light = rectangle_in(Pose::canonical, Shape::square);
  struct Place {
    float x, y;
    double spheres;
  };
  for (const Place& at : {Place{0, 0, 0.5}, Place{0.25f, -0.4f, 0.5}, Place{0.5f, 0.1f, 0.25}, Place{0, -0.5f, 0.25},
                          Place{0.5f, 0.5f, 0.125}, Place{-0.5f, 0.5f, 0.125}}) {
    for (const float height : {1e-12f, 1e-20f, -1e-30f}) {
      float got = 0;
      solid_angle(light, {{&at.x, 1}, {&at.y, 1}, {&height, 1}}, {&got, 1});
      EXPECT_NEAR(static_cast<double>(got) / (4 * pi * at.spheres), 1, 1e-6) << at.x << ", " << at.y << ", " << height;
    }
  }
}

HATBOX_FOR_EVERY_ISA(RectangleHardPlaces);

}  // namespace
}  // namespace hatbox::test
