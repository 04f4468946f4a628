// Ellipses that are none: `check` names the member, every call throws it, and nothing is written.
#include "support/ellipses.h"
#include "support/sampler.h"

#include <hatbox/hatbox.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

namespace hatbox::test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float largest = std::numeric_limits<float>::max();

struct Bad {
  Ellipse light;
  std::string begins;
};

const Bad bad_lights[] = {
    {{{nan, 0, 0}, {1, 0, 0}, {0, 1, 0}}, "light.center is not finite"},
    {{{0, 0, 0}, {1, infinity, 0}, {0, 1, 0}}, "light.semi_axis_u is not finite"},
    {{{0, 0, 0}, {1, 0, 0}, {0, 1, nan}}, "light.semi_axis_v is not finite"},
    {{{0, 0, 0}, {0, 0, 0}, {0, 1, 0}}, "light.semi_axis_u is zero"},
    {{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}, "light.semi_axis_v is zero"},
    {{{0, 0, 0}, {largest, largest, 0}, {-largest, largest, 0}}, "light.semi_axis_u is longer"},
    {{{0, 0, 0}, {largest, 0, 0}, {0, largest, largest}}, "light.semi_axis_v is longer"},
    {{{0, 0, 0}, {0.9e-6f, 0, 0}, {0, 1, 0}}, "light.semi_axis_u is shorter"},
    {{{0, 0, 0}, {1, 0, 0}, {0, 0.9e-6f, 0}}, "light.semi_axis_v is shorter"},
    {{{0, 0, 0}, {1, 0, 0}, {2e-4f, 1, 0}}, "light.semi_axis_v is not perpendicular"},
    {{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}}, "light.semi_axis_v is not perpendicular"},
};

TEST(EllipseCheck, NamesTheMember) {
  for (const Bad& bad : bad_lights) EXPECT_TRUE(check(bad.light).starts_with(bad.begins)) << check(bad.light);
}

TEST(EllipseCheck, PassesWhatIsOne) {
  for (const double aspect : ellipse_aspects) {
    for (const float scale : {1.0f, 0x1p20f, 0x1p-20f, 1e-30f, 1e30f}) {
      EXPECT_EQ(check(scaled(ellipse_in(Pose::general, aspect), scale)), "");
    }
  }
  EXPECT_EQ(check(Ellipse{{0, 0, 0}, {1, 0, 0}, {0.9e-4f, 1, 0}}), "");
  EXPECT_EQ(check(Ellipse{{0, 0, 0}, {1, 0, 0}, {0, 0, 1.1e-6f}}), "");
}

class EllipseErrors : public testing::TestWithParam<bool> {};

TEST_P(EllipseErrors, EveryCallThrowsAndWritesNothing) {
  const std::vector<float> one(1, 0.5f);
  const Grain grain = GetParam() ? Grain(0) : Grain();
  const auto expect_throw = [&](const Ellipse& light, EllipseMap map, const std::string& begins) {
    const Sampler sampler("bad", light, map);
    SampleArrays samples(1);
    std::vector<float> out(1, SampleArrays::untouched), other = out;
    const Points points{one, one, one};
    const auto throws = [&](const auto& call) {
      try {
        call();
        ADD_FAILURE() << "no exception for " << begins;
      } catch (const std::invalid_argument& error) {
        EXPECT_TRUE(std::string(error.what()).starts_with(begins)) << error.what();
      }
    };
    throws([&] { sampler.sample(points, {one, one}, samples.view(), grain); });
    throws([&] { sampler.pdf_of_direction(points, {one, one, one}, out, grain); });
    throws([&] { sampler.pdf_of_place(points, {one, one}, out, grain); });
    throws([&] { sampler.invert(points, {one, one, one}, out, other, grain); });
    if (begins.starts_with("light")) throws([&] { sampler.solid_angle(points, out, grain); });
    for (const auto& column : samples.columns) EXPECT_EQ(column[0], SampleArrays::untouched);
    EXPECT_EQ(out[0], SampleArrays::untouched);
    EXPECT_EQ(other[0], SampleArrays::untouched);
  };
  for (const Bad& bad : bad_lights) expect_throw(bad.light, EllipseMap::ld_radial, bad.begins);
  expect_throw(ellipse_in(Pose::general, 0.5), static_cast<EllipseMap>(7), "map: there is no EllipseMap 7");
}

INSTANTIATE_TEST_SUITE_P(Every, EllipseErrors, testing::Bool(),
                         [](const auto& parallel) { return parallel.param ? "parallel" : "sequential"; });

/// The narrowest ellipses there are, from anywhere: nothing breaks.
TEST(EllipseCheck, NarrowLightsAreSane) {
  for (const float aspect : {1.1e-6f, 1e-4f, 1e4f, 0.9e6f}) {
    for (const float size : {1.0f, 1e-30f, 1e30f}) {
      const Ellipse light{{0, 0, 0}, {size, 0, 0}, {0, size * aspect, 0}};
      ASSERT_EQ(check(light), "");
      for (const EllipseMap map : all_ellipse_maps) {
        PointArrays points;
        for (const float x : {0.0f, 0.5f, 1.0f, 3.0f, 1e10f, 1e18f}) {
          for (const float y : {0.0f, 1e-6f, 0.01f, 2.0f, 1e18f}) {
            for (const float z : {1e-20f, 1e-6f, 0.1f, 1e5f, 1e18f}) points.push_back({size * x, size * y, size * z});
          }
        }
        const VariateArrays variates = make_variates(points.size());
        SampleArrays samples(points.size());
        sample(light, map, points.view(), variates.view(), samples.view());
        for (std::size_t i = 0; i < samples.size(); ++i) {
          for (const auto& column : samples.columns) {
            ASSERT_TRUE(std::isfinite(column[i])) << points.x[i] << ", " << points.y[i] << ", " << points.z[i];
          }
          if (samples.valid(i)) {
            ASSERT_NEAR(length(samples.direction(i)), 1, 1e-6);
            ASSERT_GT(samples.at(SampleArrays::distance, i), 0);
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace hatbox::test
