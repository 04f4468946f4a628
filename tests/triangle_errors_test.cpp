// Triangles that are none: `check` names the member, and every call throws before anything is written.
#include "support/isa_fixture.h"
#include "support/triangle_lights.h"

#include <hatbox/hatbox.h>

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>

namespace hatbox::test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr Triangle good{{1, 2, 3}, {2, 2, 3}, {1, 3, 3}};

TEST(TriangleErrors, CheckNamesTheMember) {
  EXPECT_EQ(check(good), "");
  for (const float bad : {nan, infinity, -infinity}) {
    Triangle light = good;
    light.a.y = bad;
    EXPECT_EQ(check(light), "light.a is not finite");
    light = good;
    light.b.x = bad;
    EXPECT_EQ(check(light), "light.b is not finite");
    light = good;
    light.c.z = bad;
    EXPECT_EQ(check(light), "light.c is not finite");
  }
}

TEST(TriangleErrors, DegenerateOnesAreNone) {
  const auto leaning = [](float height, float scale) {
    return Triangle{{0, 0, 0}, {3 * scale, 0, 0}, {scale, 0, height * scale}};
  };
  for (const float scale : {1.0f, 0x1p60f, 0x1p-60f}) {
    EXPECT_EQ(check(leaning(0, scale)), "light.a, b and c lie on a line");
    EXPECT_EQ(check(leaning(1e-7f, scale)), "light.a, b and c lie on a line");
    EXPECT_EQ(check(leaning(1e-6f, scale)), "");
  }
  EXPECT_EQ(check(Triangle{{-3e38f, 0, 0}, {3e38f, 0, 0}, {0, 3e38f, 0}}), "light.a, b and c are too far apart");
  EXPECT_EQ(check(Triangle{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}), "light.a, b and c lie on a line");
  EXPECT_EQ(check(Triangle{{1, 2, 3}, {1, 2, 3}, {4, 5, 6}}), "light.a, b and c lie on a line");
}

/// What a call throws, or "".
template <class Call>
std::string complaint(const Call& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(TriangleErrors, EveryCallThrowsAndWritesNothing) {
  constexpr Triangle flat{{0, 0, 0}, {1, 1, 1}, {2, 2, 2.5e-30f + 2}};
  const PointArrays points = make_points(Workload::w1, Pose::canonical, 3);
  const VariateArrays variates = make_variates(3);
  SampleArrays samples(3);
  std::vector<float> out(3, SampleArrays::untouched), more = out;
  const std::vector<float> zero(3), one(3, 1.0f);
  const auto every_call = [&](const Triangle& light, TriangleMap map, Points where) {
    const Directions directions{zero, zero, one};
    return std::vector{complaint([&] { sample(light, map, where, variates.view(), samples.view()); }),
                       complaint([&] { pdf(light, map, where, directions, out); }),
                       complaint([&] {
                         pdf(light, map, where, Places{zero, zero}, out);
                       }),
                       complaint([&] { invert(light, map, where, directions, out, more); }),
                       complaint([&] { parallel::sample(light, map, where, variates.view(), samples.view()); }),
                       complaint([&] { parallel::pdf(light, map, where, directions, out); }),
                       complaint([&] {
                         parallel::pdf(light, map, where, Places{zero, zero}, out);
                       }),
                       complaint([&] { parallel::invert(light, map, where, directions, out, more); })};
  };
  for (const std::string& message : every_call(flat, TriangleMap::spherical, points.view())) {
    EXPECT_EQ(message.find("light.a, b and c lie on a line; a (0, 0, 0), b (1, 1, 1)"), 0u) << message;
  }
  for (const std::string& message : every_call(good, static_cast<TriangleMap>(2), points.view())) {
    EXPECT_EQ(message, "map: there is no TriangleMap 2");
  }
  const Points uneven{points.view().x, points.view().y.first(2), points.view().z};
  for (const std::string& message : every_call(good, TriangleMap::area, uneven)) {
    EXPECT_EQ(message.find("points.y"), 0u) << message;
  }
  EXPECT_NE(complaint([&] { solid_angle(flat, points.view(), out); }), "");
  EXPECT_NE(complaint([&] { parallel::solid_angle(flat, points.view(), out); }), "");
  for (const auto& column : samples.columns) {
    for (const float value : column) EXPECT_EQ(value, SampleArrays::untouched);
  }
  for (const auto* values : {&out, &more}) {
    for (const float value : *values) EXPECT_EQ(value, SampleArrays::untouched);
  }
}

}  // namespace
}  // namespace hatbox::test
