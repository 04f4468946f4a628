// Segments clipped to the lit side of a plane: what is left is lit, what is cut is not, as far as an ulp of t can tell.
#include "support/bits.h"
#include "support/isa_fixture.h"
#include "support/random.h"
#include "support/segments.h"
#include "support/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace hatbox::test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

class SegmentClip : public IsaAndPoseTest {};

struct Parts {
  std::vector<float> t_min, t_max;
};

Parts clip(const SegmentArrays& segments, const PointArrays& normals, std::optional<std::size_t> grain = {}) {
  const Directions n{normals.x, normals.y, normals.z};
  Parts out{std::vector<float>(segments.size(), -1), std::vector<float>(segments.size(), -1)};
  if (grain) {
    parallel::equiangular::clip(segments.view(), segments.pivot.view(), n, out.t_min, out.t_max, *grain);
  } else {
    equiangular::clip(segments.view(), segments.pivot.view(), n, out.t_min, out.t_max);
  }
  return out;
}

/// Every direction and many lengths; one in four nearly across the ray, and thus the plane nearly along it.
PointArrays make_normals(const SegmentArrays& segments) {
  Random random(9);
  PointArrays normals;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    using reference::Vector;
    Vector<double> n{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    if (i % 4 == 0) {
      const auto d = reference::convert<double>(segments.direction[i]);
      n = cross(d, n) + random.log_uniform(1e-7, 1e-2) * d;
    }
    n = random.log_uniform(1e-10, 1e10) * n;
    normals.push_back({static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)});
  }
  return normals;
}

TEST_P(SegmentClip, KeepsTheLitPart) {
  for (const Situation situation : all_situations) {
    const SegmentArrays segments = make_segments(situation, pose(), 2000);
    const PointArrays normals = make_normals(segments);
    const Parts got = clip(segments, normals);
    for (std::size_t i = 0; i < segments.size(); ++i) {
      SCOPED_TRACE(std::string(name(situation)) + " segment " + std::to_string(i));
      const reference::Segment s = segments.segment(i);
      const auto lit = [&](double t) { return height(s, t, segments.pivot[i], normals[i]) > 0; };
      const double from = got.t_min[i], to = got.t_max[i];
      if (from == 0 && to == 0) {  // at most an ulp of it is lit
        const double begin = s.t_min, end = s.t_max;
        ASSERT_FALSE(lit(begin + ulp(s.t_min)) && lit(end));
        ASSERT_FALSE(lit(end - ulp(s.t_max)) && lit(begin));
        continue;
      }
      ASSERT_LT(from, to);
      ASSERT_GE(from, s.t_min);
      ASSERT_LE(to, s.t_max);
      const double first = ulp(got.t_min[i]), last = ulp(got.t_max[i]);
      if (from + first < to - last) {
        ASSERT_TRUE(lit(from + first));
        ASSERT_TRUE(lit(to - last));
      }
      if (from > s.t_min) {
        ASSERT_FALSE(lit(from - first));
      }
      if (to < s.t_max) {
        ASSERT_FALSE(lit(to + last));
      }
    }
  }
}

TEST_P(SegmentClip, HardSegments) {
  const Vec3 zero{0, 0, 0}, along{1, 0, 0}, up{0, 0, 1};
  struct Case {
    reference::Segment segment;
    Vec3 on_plane, normal;
    float from, to;
  };
  const Case cases[] = {
      {{{0, 0, 1}, along, 2, 5}, zero, up, 2, 5},          // along the plane, above, below, in it
      {{{0, 0, -1}, along, 2, 5}, zero, up, 0, 0},         //
      {{zero, along, 2, 5}, zero, up, 0, 0},               //
      {{zero, along, 1, 5}, {3, 0, 0}, along, 3, 5},       // across it
      {{zero, along, 1, 5}, {3, 0, 0}, {-1, 0, 0}, 1, 3},  //
      {{zero, along, 1, 5}, {1, 0, 0}, along, 1, 5},       // touching it
      {{zero, along, 1, 5}, {5, 0, 0}, along, 0, 0},       //
      {{zero, along, 1, infinity}, {3, 0, 0}, along, 3, infinity},
      {{zero, along, 1, infinity}, {3, 0, 0}, {-1, 0, 0}, 1, 3},
      {{zero, along, 1, infinity}, {0, 0, -1}, up, 1, infinity},
      {{zero, along, -1, 5}, zero, along, 0, 5},
      {{zero, along, 1, 5}, {3, 0, 0}, {1e30f, 0, 0}, 3, 5},
      {{zero, along, 1, 5}, {3, 0, 0}, {1e-30f, 0, 0}, 3, 5},
      {{zero, along, 1, 5}, {3, 0, 0}, zero, 0, 0},  // bad ones
      {{zero, along, 1, 5}, {3, 0, 0}, {nan, 0, 1}, 0, 0},
      {{zero, along, 1, 5}, {3, 0, 0}, {infinity, 0, 1}, 0, 0},
      {{zero, along, 1, 5}, {nan, 0, 0}, up, 0, 0},
      {{zero, along, 1, 5}, {0, infinity, 0}, up, 0, 0},
      {{{0, -infinity, 1}, along, 1, 5}, zero, up, 0, 0},
      {{{0, 0, 1}, zero, 1, 5}, zero, up, 0, 0},
      {{{0, 0, 1}, {nan, 0, 0}, 1, 5}, zero, up, 0, 0},
      {{{0, 0, 1}, along, nan, 5}, zero, up, 0, 0},
      {{{0, 0, 1}, along, 1, nan}, zero, up, 0, 0},
      {{{0, 0, 1}, along, -infinity, 5}, zero, up, 0, 0},
      {{{0, 0, 1}, along, 5, 5}, zero, up, 0, 0},
      {{{0, 0, 1}, along, 5, 1}, zero, up, 0, 0},
  };
  SegmentArrays segments;
  PointArrays normals;
  for (const Case& c : cases) {
    segments.push_back(c.segment, c.on_plane);
    normals.push_back(c.normal);
  }
  const Parts got = clip(segments, normals);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    EXPECT_TRUE(same_bits(got.t_min[i], cases[i].from)) << "case " << i << " " << got.t_min[i];
    EXPECT_TRUE(same_bits(got.t_max[i], cases[i].to)) << "case " << i << " " << got.t_max[i];
  }
}

TEST_P(SegmentClip, BitsAreTheSameEverywhere) {
  SegmentArrays segments = mixed_segments(pose(), 131);
  const PointArrays normals = make_normals(segments);
  const Parts expected = clip(segments, normals);
  const std::size_t n = segments.size();
  const Parts split = clip(segments, normals, 40);
  EXPECT_EQ(first_difference(split.t_min, expected.t_min), n);
  EXPECT_EQ(first_difference(split.t_max, expected.t_max), n);
  for (std::size_t i = 0; i < n; ++i) {  // alone
    const std::size_t one[] = {i};
    PointArrays normal;
    normal.push_back(normals[i]);
    const Parts got = clip(segments.pick(one), normal);
    ASSERT_TRUE(same_bits(got.t_min[0], expected.t_min[i]) && same_bits(got.t_max[0], expected.t_max[i])) << i;
  }
  if (isa() != Isa::sse4_2) {  // whose fma is rounded twice
    const ForcedIsa scalar(Isa::scalar);
    const Parts of_scalar = clip(segments, normals);
    EXPECT_EQ(first_difference(of_scalar.t_min, expected.t_min), n);
    EXPECT_EQ(first_difference(of_scalar.t_max, expected.t_max), n);
  }
  // In place: the one call whose outputs may be its inputs.
  equiangular::clip(segments.view(), segments.pivot.view(), {normals.x, normals.y, normals.z}, segments.t_min,
                    segments.t_max);
  EXPECT_EQ(first_difference(segments.t_min, expected.t_min), n);
  EXPECT_EQ(first_difference(segments.t_max, expected.t_max), n);
}

TEST_P(SegmentClip, ErrorsNameTheSpan) {
  const SegmentArrays segments = make_segments(Situation::ordinary, pose(), 4);
  const std::vector<float> four(4, 1), three(3, 1);
  std::vector<float> from(4, -1), to(4, -1);
  const auto message_of = [&](Points on_plane, Directions normals, std::span<float> t_min, std::span<float> t_max) {
    try {
      equiangular::clip(segments.view(), on_plane, normals, t_min, t_max);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const Points p{four, four, four};
  const Directions n{four, four, four};
  const std::span<float> short_one = std::span(from).first(3);
  EXPECT_EQ(message_of({four, three, four}, n, from, to), "on_plane.y: has 3 elements, expected 4");
  EXPECT_EQ(message_of(p, {four, four, three}, from, to), "normals.z: has 3 elements, expected 4");
  EXPECT_EQ(message_of(p, n, short_one, to), "t_min: has 3 elements, expected 4");
  EXPECT_EQ(message_of(p, n, from, short_one), "t_max: has 3 elements, expected 4");
  for (std::size_t i = 0; i < 4; ++i) EXPECT_TRUE(from[i] == -1 && to[i] == -1);
}

HATBOX_FOR_EVERY_ISA_AND_POSE(SegmentClip);

}  // namespace
}  // namespace hatbox::test
