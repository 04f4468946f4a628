// Calls that cannot be right: the exception names the argument, sequential and parallel alike, and nothing is written.
// What is wrong with arrays is the same code for all lights and tested with the disk's.
#include "support/rectangles.h"
#include "support/workloads.h"

#include <hatbox/hatbox.h>

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

namespace hatbox::test {
namespace {

constexpr std::size_t n = 6;
constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

/// Arrays of the right length for every call.
struct Arguments {
  PointArrays points = make_points(Workload::w1, Pose::general, n);
  VariateArrays variates = make_variates(n);
  std::vector<float> x = std::vector<float>(n, 0.6f), y = std::vector<float>(n, 0.0f), z = std::vector<float>(n, -0.8f);
  SampleArrays samples{n};
  std::vector<float> u = std::vector<float>(n, SampleArrays::untouched), v = u;

  bool untouched() const {
    bool result = true;
    for (const float value : samples.columns[0]) result = result && value == SampleArrays::untouched;
    for (const float value : u) result = result && value == SampleArrays::untouched;
    return result;
  }
};

using Call = std::function<void(const Rectangle&, RectangleMap, Arguments&)>;

const Call with_map[] = {
    [](const Rectangle& light, RectangleMap map, Arguments& a) {
      sample(light, map, a.points.view(), a.variates.view(), a.samples.view());
    },
    [](const Rectangle& light, RectangleMap map, Arguments& a) {
      pdf(light, map, a.points.view(), Directions{a.x, a.y, a.z}, a.u);
    },
    [](const Rectangle& light, RectangleMap map, Arguments& a) {
      pdf(light, map, a.points.view(), Places{a.x, a.y}, a.u);
    },
    [](const Rectangle& light, RectangleMap map, Arguments& a) {
      invert(light, map, a.points.view(), {a.x, a.y, a.z}, a.u, a.v);
    },
    [](const Rectangle& light, RectangleMap map, Arguments& a) {
      parallel::sample(light, map, a.points.view(), a.variates.view(), a.samples.view());
    },
    [](const Rectangle& light, RectangleMap map, Arguments& a) {
      parallel::pdf(light, map, a.points.view(), Directions{a.x, a.y, a.z}, a.u);
    },
    [](const Rectangle& light, RectangleMap map, Arguments& a) {
      parallel::pdf(light, map, a.points.view(), Places{a.x, a.y}, a.u);
    },
    [](const Rectangle& light, RectangleMap map, Arguments& a) {
      parallel::invert(light, map, a.points.view(), {a.x, a.y, a.z}, a.u, a.v);
    },
};

const Call without_map[] = {
    [](const Rectangle& light, RectangleMap, Arguments& a) { solid_angle(light, a.points.view(), a.u); },
    [](const Rectangle& light, RectangleMap, Arguments& a) { parallel::solid_angle(light, a.points.view(), a.u); },
};

void expect_complaint(const Call& call, const Rectangle& light, RectangleMap map, const std::string& named) {
  Arguments arguments;
  try {
    call(light, map, arguments);
    ADD_FAILURE() << "no exception; wanted " << named;
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(named), std::string::npos)
        << "wanted " << named << " in: " << error.what();
  }
  EXPECT_TRUE(arguments.untouched()) << named;
}

TEST(RectangleErrors, NoneWhenAllIsRight) {
  for (const Shape shape : all_shapes) {
    for (const Pose pose : {Pose::canonical, Pose::general}) EXPECT_EQ(check(rectangle_in(pose, shape)), "");
  }
  for (const Call& call : with_map) {
    Arguments arguments;
    call(rectangle_in(Pose::general, Shape::square), RectangleMap::spherical, arguments);
    EXPECT_FALSE(arguments.untouched());
  }
}

TEST(RectangleErrors, BadLightIsNamed) {
  constexpr float big = 3e38f;
  const std::pair<const char*, Rectangle> cases[] = {
      {"light.corner", {{0, nan, 0}, {1, 0, 0}, {0, 1, 0}}},
      {"light.corner", {{0, 0, -infinity}, {1, 0, 0}, {0, 1, 0}}},
      {"light.edge_u", {{0, 0, 0}, {nan, 0, 0}, {0, 1, 0}}},
      {"light.edge_u", {{0, 0, 0}, {0, 0, -0.0f}, {0, 1, 0}}},
      {"light.edge_u", {{0, 0, 0}, {1e-40f, 0, 0}, {0, 1, 0}}},
      {"light.edge_u", {{0, 0, 0}, {big, big, 0}, {0, 0, 1}}},
      {"light.edge_v", {{0, 0, 0}, {1, 0, 0}, {0, infinity, 0}}},
      {"light.edge_v", {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}},
      {"light.edge_v", {{0, 0, 0}, {1, 0, 0}, {0, big, big}}},
      {"light.edge_v", {{0, 0, 0}, {1, 0, 0}, {1.1e-4f, 1, 0}}},
      {"light.edge_v", {{0, 0, 0}, {1, 0, 0}, {-3, 0, 0}}},
  };
  for (const auto& [named, light] : cases) {
    EXPECT_TRUE(check(light).starts_with(named)) << check(light);
    for (const Call& call : with_map) expect_complaint(call, light, RectangleMap::area, named);
    for (const Call& call : without_map) expect_complaint(call, light, RectangleMap::area, named);
  }
  EXPECT_EQ(check(Rectangle{{0, 0, 0}, {1, 0, 0}, {0.9e-4f, 1, 0}}), "");
  EXPECT_EQ(check(Rectangle{{0, 0, 0}, {1e30f, 0, 0}, {0, 1e-30f, 0}}), "");
}

TEST(RectangleErrors, TheValueIsGiven) {
  expect_complaint(without_map[0], {{0, 0, 0}, {2.5f, 0, 0}, {-7.25f, 0, 0}}, RectangleMap::area, "-7.25");
  expect_complaint(with_map[0], rectangle_in(Pose::general, Shape::square), static_cast<RectangleMap>(77), "77");
}

TEST(RectangleErrors, UnknownMapIsNamed) {
  for (const Call& call : with_map) {
    expect_complaint(call, rectangle_in(Pose::general, Shape::square), static_cast<RectangleMap>(-1), "map");
  }
}

}  // namespace
}  // namespace hatbox::test
