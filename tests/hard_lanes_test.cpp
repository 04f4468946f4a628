// Lanes found by fuzzing, each where a formula or a sign once went wrong: on a light's axes, at its vertices, beside it
// almost in its plane.
#include "support/bits.h"
#include "support/denormals.h"
#include "support/isa_fixture.h"
#include "support/sampler_calls.h"

#include <hatbox/hatbox.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace hatbox::test {
namespace {

class HardLanes : public IsaTest {};

constexpr Rectangle unit_square{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
constexpr Triangle right_triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

std::vector<Sampler> aligned_samplers() {
  const Disk disk = {{0, 0, 0}, {0, 0, 1}, 1};
  const Ellipse wide = {{0, 0, 0}, {1, 0, 0}, {0, 0.1f, 0}}, tall = {{0, 0, 0}, {0.1f, 0, 0}, {0, 1, 0}};
  return {{"disk", disk, DiskMap::ld_radial},
          {"disk_parallel", disk, DiskMap::parallel},
          {"wide", wide, EllipseMap::ld_radial},
          {"tall", tall, EllipseMap::radial},
          {"rectangle", unit_square, RectangleMap::spherical},
          {"two_triangles", unit_square, RectangleMap::two_triangles},
          {"triangle", right_triangle, TriangleMap::spherical}};
}

/// Zeros of either sign come up on a light's axes, and what an instruction set makes of −0 must not show.
TEST_P(HardLanes, BitsOnAxesOfSymmetryAreThoseOfScalar) {
  PointArrays points;
  for (const float a : {-2.0f, -0.7f, -0.0f, 0.0f, 0.5f, 1.0f, 1.5f}) {
    for (const float height : {-0.5f, 1e-3f, 2.0f}) {
      points.push_back({a, 0, height});
      points.push_back({0, a, height});
      points.push_back({a, -0.0f, height});
      points.push_back({a, a, height});
    }
  }
  for (const Sampler& sampler : aligned_samplers()) {
    Queries queries = make_queries(sampler, points, 3);
    for (std::size_t i = 0; i < queries.size(); i += 2) queries.variates.u[i] = 0.5f;
    const auto got = call_everything(sampler, queries);
    const ForcedIsa scalar(Isa::scalar);
    const auto expected = call_everything(sampler, queries);
    for (std::size_t c = 0; c < got.size(); ++c) {
      EXPECT_EQ(first_difference(got[c].values, expected[c].values), got[c].values.size())
          << sampler.name << " " << got[c].name;
    }
  }
}

/// Squares of what is small are then gone before their sums are.
TEST_P(HardLanes, DirectionsAreOfUnitLengthWhereDenormalsAreFlushed) {
  PointArrays points;
  for (double off = 1e-22; off < 1e-15; off *= 1.3) {
    const double angle = 1e18 * off;
    const auto x = static_cast<float>(off * std::cos(angle)), y = static_cast<float>(off * std::sin(angle));
    for (const float height : {1e-25f, 1e-13f, 1.0f, 1e3f}) points.push_back({x, y, height});
    for (const double far : {1e16, 1e17, 3e17}) {
      points.push_back({static_cast<float>(far * 0.01 * std::cos(angle)),
                        static_cast<float>(far * 0.01 * std::sin(angle)), static_cast<float>(far)});
    }
  }
  const VariateArrays variates = make_variates(points.size());
  for (const Sampler& sampler : aligned_samplers()) {
    SampleArrays samples(points.size());
    {
      const FlushedDenormals flushed;
      sampler.sample(points.view(), variates.view(), samples.view(), {});
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!samples.valid(i)) continue;
      ASSERT_NEAR(length(samples.direction(i)), 1, 2e-6)
          << sampler.name << " from " << points.x[i] << ", " << points.y[i] << ", " << points.z[i];
    }
  }
}

/// Seen edge-on all sides are nearly in one plane, and most of what lies in it is no hit.
TEST_P(HardLanes, BeyondALightSeenEdgeOnIsAMiss) {
  for (const Sampler& sampler : {Sampler("rectangle", unit_square, RectangleMap::spherical),
                                 Sampler("two_triangles", unit_square, RectangleMap::two_triangles),
                                 Sampler("triangle", right_triangle, TriangleMap::spherical)}) {
    for (const float height : {1e-5f, 1e-6f, 1e-7f, 1e-8f}) {
      for (const Vec3 point : {Vec3{-3, 0.25f, height}, Vec3{0.2f, -0.05f, height}, Vec3{-0.05f, 0.3f, height}}) {
        PointArrays points;
        std::vector<float> x, y, z;
        for (int i = 0; i < 64; ++i) {
          const double angle = 2 * M_PI * i / 64, dx = std::cos(angle), dy = std::sin(angle);
          // Where the direction passes the square, seen from above, with room to spare.
          bool near = false;
          for (double way = 0; way < 8; way += 0.01) {
            const double px = point.x + way * dx, py = point.y + way * dy;
            near = near || (px > -0.02 && px < 1.02 && py > -0.02 && py < 1.02);
          }
          if (near) continue;
          points.push_back(point);
          x.push_back(static_cast<float>(dx));
          y.push_back(static_cast<float>(dy));
          z.push_back(0);
        }
        ASSERT_GT(points.size(), 10u);
        std::vector<float> density(points.size());
        sampler.pdf_of_direction(points.view(), {x, y, z}, density, {});
        for (std::size_t i = 0; i < density.size(); ++i) {
          ASSERT_EQ(density[i], 0) << sampler.name << " from height " << height << " along " << x[i] << ", " << y[i];
        }
      }
    }
  }
}

/// At a vertex of a triangle in a general pose all its heights are rounding noise: a sample there is right or none.
TEST_P(HardLanes, DirectionsFromVerticesAreUnitOrNone) {
  const VariateArrays numbers = make_variates(9 * 2000);
  std::size_t sampled = 0;
  for (std::size_t i = 0; i + 9 <= numbers.size(); i += 9) {
    const auto vertex = [&](std::size_t j) {
      return Vec3{2 * numbers.u[i + 3 * j] - 1, 2 * numbers.u[i + 3 * j + 1] - 1, 2 * numbers.u[i + 3 * j + 2] - 1};
    };
    const Triangle light = {vertex(0), vertex(1), vertex(2)};
    PointArrays points;
    for (const Vec3& p : {light.a, light.b, light.c}) points.push_back(p);
    const std::vector<float> u{0.3f, 0.3f, 0.3f}, v{0.4f, 0.4f, 0.4f};
    SampleArrays samples(3);
    sample(light, TriangleMap::spherical, points.view(), {u, v}, samples.view());
    for (std::size_t lane = 0; lane < 3; ++lane) {
      if (!samples.valid(lane)) continue;
      ++sampled;
      ASSERT_NEAR(length(samples.direction(lane)), 1, 1e-6) << "triangle " << i / 9 << " vertex " << lane;
    }
  }
  EXPECT_GT(sampled, 0u);
}

/// Beside a light its solid angle is proportional to the height, down to the smallest floats.
TEST_P(HardLanes, SolidAngleBesideTheLightFollowsTheHeight) {
  PointArrays points;
  for (float height = 1e-3f; height > 1e-34f; height *= 0.1f) points.push_back({3, 0.2f, height});
  const std::vector<float> u(points.size(), 0.3f), v(points.size(), 0.6f);
  for (const Sampler& sampler : {Sampler("rectangle", unit_square, RectangleMap::spherical),
                                 Sampler("two_triangles", unit_square, RectangleMap::two_triangles),
                                 Sampler("triangle", right_triangle, TriangleMap::spherical)}) {
    std::vector<float> omega(points.size());
    SampleArrays samples(points.size());
    sampler.solid_angle(points.view(), omega, {});
    sampler.sample(points.view(), {u, v}, samples.view(), {});
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double ratio = static_cast<double>(omega[i]) / static_cast<double>(points.z[i]);
      ASSERT_NEAR(ratio / (static_cast<double>(omega[0]) / 1e-3), 1, 1e-5) << sampler.name << " height " << points.z[i];
      ASSERT_NEAR(static_cast<double>(samples.at(SampleArrays::pdf, i)) * static_cast<double>(omega[i]), 1, 2e-6);
    }
  }
}

/// Next to the tip of a narrow ellipse a root's product may be rounded below 0.
TEST_P(HardLanes, NextToTheTipOfANarrowEllipse) {
  const Ellipse light = {{0, 0, 0}, {1, 0, 0}, {0, 0.01f, 0}};
  PointArrays points;
  points.push_back({-0.999956846f, -1.69635427e-6f, 6.84585757e-7f});
  std::vector<float> omega(1);
  solid_angle(light, points.view(), omega);
  EXPECT_NEAR(omega[0], 6.2350879, 1e-5);
}

/// A point of the square that is off the disk by less than its own rounding is not taken.
TEST_P(HardLanes, RejectionNextToTheRimStaysOnTheDisk) {
  const Disk light = {{0, 0, 0}, {0, 0, 1}, 1};
  PointArrays points;
  points.push_back({1, 0.00638845f, 2.489e-5f});
  const std::vector<float> u{1e-42f}, v{0.679347396f};
  SampleArrays samples(1);
  sample(light, DiskMap::rejection, points.view(), {u, v}, samples.view());
  ASSERT_TRUE(samples.valid(0));
  std::vector<float> density(1);
  pdf(light, DiskMap::rejection, points.view(), samples.directions(), density);
  EXPECT_GT(density[0], 0);
}

/// Next to the disk's centre the squares of a place are denormal, and the angle it lies at was no unit vector.
TEST_P(HardLanes, NextToTheCentreThePlaceAndTheDirectionHaveTheSamplesDensity) {
  const Disk disk = {{0, 0, 0}, {0, 1, 0}, 0.0625f};
  const Ellipse circle = {{0, 0, 0}, {0, 0, 0.0625f}, {0.0625f, 0, 0}};
  for (const Sampler& sampler :
       {Sampler("disk", disk, DiskMap::radial), Sampler("circle", circle, EllipseMap::radial)}) {
    PointArrays points;
    for (float off = 1e-12f; off > 1e-24f; off *= 0.7f) points.push_back({0, 0.79086334f, off});
    const std::vector<float> u(points.size(), 0x1p-10f), v(points.size(), 0.0f);
    SampleArrays samples(points.size());
    std::vector<float> of_place(points.size()), of_direction(points.size());
    sampler.sample(points.view(), {u, v}, samples.view(), {});
    sampler.pdf_of_place(points.view(), samples.places(), of_place, {});
    sampler.pdf_of_direction(points.view(), samples.directions(), of_direction, {});
    for (std::size_t i = 0; i < points.size(); ++i) {
      const float density = samples.at(SampleArrays::pdf, i);
      ASSERT_NEAR(of_place[i] / density, 1, 1e-5) << sampler.name << " off the axis by " << points.z[i];
      ASSERT_NEAR(of_direction[i] / density, 1, 1e-5) << sampler.name << " off the axis by " << points.z[i];
    }
  }
}

/// A negative of zero is −0 on every instruction set.
TEST_P(HardLanes, BitsNextToTheRimAreThoseOfScalar) {
  const Ellipse ellipse = {{0, 0, 0}, {0x1p-58f, 0, 0}, {0, 0x1.ff8p-59f, 0}};
  PointArrays point;
  point.push_back({0, 0x1.ff8p-59f, 0x1p-149f});
  const std::vector<float> half{0.5f}, low{0x1p-10f};
  const auto sampled = [&] {
    SampleArrays samples(1);
    sample(ellipse, EllipseMap::radial, point.view(), {half, low}, samples.view());
    return samples;
  };
  const SampleArrays got = sampled();
  const ForcedIsa scalar(Isa::scalar);
  const SampleArrays expected = sampled();
  for (std::size_t c = 0; c < got.columns.size(); ++c) {
    if (GetParam() == Isa::sse4_2) continue;
    EXPECT_EQ(first_difference(got.columns[c], expected.columns[c]), 1u) << "output " << c;
  }
}

/// A distance that is not its own, seen from as near as this, is none.
TEST_P(HardLanes, RejectionAHairAboveTheRimIsUnitOrNone) {
  const Disk light = {{0, 0, 0}, {0, 0, 1}, 0x1p-73f};
  PointArrays points;
  points.push_back({-0x1p-73f, 0x1.1a6264p-126f, 0x1p-149f});
  const std::vector<float> u{0x1p-10f}, v{0x1p-10f};
  SampleArrays samples(1);
  sample(light, DiskMap::rejection, points.view(), {u, v}, samples.view());
  if (!samples.valid(0)) return;
  EXPECT_NEAR(length(samples.direction(0)), 1, 1e-6);
}

/// Seen along one of its edges, 1 − h of a rectangle's line is denormal.
TEST_P(HardLanes, ARectangleSeenAlongAnEdgeKeepsItsDirectionsWhereDenormalsAreFlushed) {
  const Rectangle light = {{0, 0, 0}, {0x1p-55f, 0, 0}, {0, 0x1p-55f, 0}};
  PointArrays points;
  points.push_back({0, 0, 0x1p-126f});
  for (float height = 1e-20f; height > 1e-38f; height *= 0.1f) points.push_back({height, -50 * 0x1p-55f, height});
  const std::vector<float> u(points.size(), 0.0f), v(points.size(), 0x1.7p-5f);
  SampleArrays samples(points.size());
  {
    const FlushedDenormals flushed;
    sample(light, RectangleMap::spherical, points.view(), {u, v}, samples.view());
  }
  std::size_t sampled = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!samples.valid(i)) continue;
    ++sampled;
    EXPECT_NEAR(length(samples.direction(i)), 1, 1e-6) << "from height " << points.z[i];
  }
  EXPECT_GT(sampled, 5u);
}

/// Whether denormals are flushed or not. The first `sampled` of the points are to be sampled.
template <class Light, class Map>
void expect_unit_directions(const Light& light, Map map, const PointArrays& points, std::size_t sampled,
                            std::array<float, 2> variates) {
  const std::vector<float> u(points.size(), variates[0]), v(points.size(), variates[1]);
  for (const bool flush : {false, true}) {
    SampleArrays samples(points.size());
    {
      const FlushedDenormals flushed(flush);
      sample(light, map, points.view(), {u, v}, samples.view());
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      ASSERT_TRUE(samples.valid(i) || i >= sampled);
      if (!samples.valid(i)) continue;
      EXPECT_NEAR(length(samples.direction(i)), 1, 1e-6) << "from height " << points.z[i] << (flush ? ", flushed" : "");
    }
  }
}

constexpr Ellipse circle = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

/// Next to an ellipse's centre the squares of its cone's tilt are denormal.
TEST_P(HardLanes, AnEllipseSeenFromNextToItsCentreKeepsItsDirectionsWhereDenormalsAreFlushed) {
  PointArrays points;
  for (float far = 1e-5f; far > 1e-18f; far *= 0.9f) points.push_back({0.9f * far, 0.4f * far, 0.55f * far});
  expect_unit_directions(circle, EllipseMap::ld_radial, points, points.size(), {0.17f, 0.48f});
}

/// From as far as there are squares of distances their inverses are denormal.
TEST_P(HardLanes, AnEllipseSeenFromAsFarAsCanBeKeepsItsDirectionsWhereDenormalsAreFlushed) {
  for (const Vec3 way : {Vec3{0, 0.1f, 1}, Vec3{0.37f, 0.87f, 0.31f}}) {
    PointArrays points;
    std::size_t near = 0;
    for (float far = 1e17f; far < 2e19f; far *= 1.03f) {
      points.push_back({far * way.x, far * way.y, far * way.z});
      if (far <= 4e18f) near = points.size();
    }
    expect_unit_directions(circle, EllipseMap::radial, points, near, {0.17f, 0.48f});
  }
}

/// From next to the very place that is picked, the squares of a ray are denormal.
TEST_P(HardLanes, RaysToAPlaceNextToThePointAreOfUnitLengthWhereDenormalsAreFlushed) {
  PointArrays points;
  std::size_t apart = 0;
  for (float far = 1e-8f; far > 1e-24f; far *= 0.9f) {
    points.push_back({0.62f * far, 0.77f * far, 0.14f * far});
    if (0.62f * far >= 1e-14f) apart = points.size();
  }
  expect_unit_directions(Disk{{0, 0, 0}, {0, 0, 1}, 1}, DiskMap::area, points, apart, {0.5f, 0.5f});
  expect_unit_directions(circle, EllipseMap::area, points, apart, {0.5f, 0.5f});
  expect_unit_directions(unit_square, RectangleMap::area, points, apart, {0, 0});
  expect_unit_directions(right_triangle, TriangleMap::area, points, apart, {0, 0});
}

HATBOX_FOR_EVERY_ISA(HardLanes);

}  // namespace
}  // namespace hatbox::test
