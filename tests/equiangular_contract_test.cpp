// What equiangular sampling promises whatever its inputs: bad lanes are 0 and touch no other, bits depend on a lane's
// own inputs alone, powers of two scale exactly, errors name the span.
#include "support/bits.h"
#include "support/isa_fixture.h"
#include "support/lane_faults.h"
#include "support/random.h"
#include "support/segments.h"
#include "support/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

namespace hatbox::test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float largest = std::numeric_limits<float>::max();
constexpr float subnormal = 1e-42f;

class EquiangularContract : public IsaAndPoseTest {};

std::vector<std::size_t> in_order(std::size_t n) {
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  return order;
}

/// All of the numbers of a segment and its pivot.
std::vector<std::vector<float>*> columns(SegmentArrays& s) {
  return {&s.origin.x, &s.origin.y, &s.origin.z, &s.direction.x, &s.direction.y, &s.direction.z,
          &s.pivot.x,  &s.pivot.y,  &s.pivot.z,  &s.t_min,       &s.t_max};
}

void expect_sane(const SegmentArrays& segments, std::span<const float> u, const DistanceArrays& got) {
  const std::size_t n = segments.size();
  const std::vector<float> asked = pdf(segments, got.t);
  for (std::size_t i = 0; i < u.size(); ++i) {
    const char* const fault = fault_of_distance(segments.segment(i % n), got.t[i], got.pdf[i], asked[i]);
    ASSERT_EQ(fault, nullptr) << "lane " << i << ": " << fault;
  }
}

/// One number after another of good segments replaced by a bad one, in every other lane.
TEST_P(EquiangularContract, BadLanesAreSaneAndTouchNoOther) {
  const float strange[] = {nan,      infinity, -infinity, 0.0f,  -0.0f,  subnormal, -subnormal, largest,
                           -largest, 1e-30f,   -1e-30f,   1e30f, -1e30f, 1e-20f,    1e20f,      1};
  const SegmentArrays good = mixed_segments(pose(), 9);
  const std::size_t n = good.size();
  const std::vector<float> u = make_variates(n).u;
  const DistanceArrays expected = sample(good, u);
  for (std::size_t c = 0; c < 11; ++c) {
    for (const float value : strange) {
      SCOPED_TRACE("column " + std::to_string(c) + " value " + std::to_string(value));
      SegmentArrays changed = good;
      for (std::size_t i = 0; i < n; i += 2) (*columns(changed)[c])[i] = value;
      const DistanceArrays got = sample(changed, u);
      expect_sane(changed, u, got);
      for (std::size_t i = 1; i < n; i += 2) {
        ASSERT_TRUE(same_bits(got.t[i], expected.t[i]) && same_bits(got.pdf[i], expected.pdf[i])) << "lane " << i;
      }
      const bool spoils = !std::isfinite(value) && !(c == 10 && value > 0);
      for (std::size_t i = 0; i < n && spoils; i += 2) ASSERT_EQ(got.pdf[i], 0) << "lane " << i;
    }
  }
}

/// All numbers of all magnitudes, the same one often twice so that differences vanish.
TEST_P(EquiangularContract, NumbersOfAllMagnitudesAreSane) {
  Random random(6);
  constexpr std::size_t n = 20000;
  const auto number = [&] {
    const double roll = random.unit();
    if (roll < 0.1) return 0.0f;
    const double magnitude = roll < 0.4   ? 1
                             : roll < 0.7 ? random.log_uniform(1e-3, 1e3)
                                          : random.log_uniform(1e-44, 3e38);
    return static_cast<float>(random.unit() < 0.5 ? -magnitude : magnitude);
  };
  SegmentArrays segments;
  PointArrays normals;
  for (std::size_t i = 0; i < n; ++i) {
    const auto three = [&] { return Vec3{number(), number(), number()}; };
    segments.push_back({three(), three(), number(), i % 9 ? number() : infinity}, three());
    normals.push_back(three());
    if (i % 2) std::swap(segments.t_min[i], segments.t_max[i]);
    if (segments.t_min[i] > segments.t_max[i]) std::swap(segments.t_min[i], segments.t_max[i]);
  }
  const std::vector<float> u = make_variates(n).u;
  const DistanceArrays got = sample(segments, u);
  expect_sane(segments, u, got);
  EXPECT_GT(std::ranges::count_if(got.pdf, [](float density) { return density > 0; }), n / 10);
  std::vector<float> from(n), to(n);
  equiangular::clip(segments.view(), segments.pivot.view(), {normals.x, normals.y, normals.z}, from, to);
  for (std::size_t i = 0; i < n; ++i) {
    const char* const fault = fault_of_clipped(segments.segment(i), from[i], to[i]);
    ASSERT_EQ(fault, nullptr) << "lane " << i << ": " << fault;
  }
}

TEST_P(EquiangularContract, StrangeVariatesSpoilTheirOwnLaneAtMost) {
  const SegmentArrays segments = mixed_segments(pose(), 8);
  const std::size_t n = segments.size();
  for (const float value : {nan, infinity, -infinity}) {
    const DistanceArrays got = sample(segments, std::vector<float>(n, value));
    for (std::size_t i = 0; i < n; ++i) ASSERT_TRUE(got.t[i] == 0 && got.pdf[i] == 0) << i;
  }
  const DistanceArrays first = sample(segments, std::vector<float>(n, 0));
  const DistanceArrays last = sample(segments, std::vector<float>(n, 1 - 0x1p-24f));
  for (const float value : {-0.0f, -1.0f, -largest, subnormal, 1.0f, largest}) {
    const std::vector<float> u(n, value);
    const DistanceArrays got = sample(segments, u);
    expect_sane(segments, u, got);
    const DistanceArrays& expected = value > 0.5f ? last : first;
    for (std::size_t i = 0; i < n && value != subnormal; ++i) ASSERT_TRUE(same_bits(got.t[i], expected.t[i])) << i;
  }
}

/// Segments that have no inside, and pivots where they should not be.
TEST_P(EquiangularContract, DegenerateSegments) {
  const Vec3 zero{0, 0, 0}, along{1, 0, 0};
  SegmentArrays none, some;
  none.push_back({zero, along, 1, 1}, {0, 1, 0});
  none.push_back({zero, along, 2, 1}, {0, 1, 0});
  none.push_back({zero, along, infinity, infinity}, {0, 1, 0});
  none.push_back({zero, zero, 0, 1}, {0, 1, 0});
  none.push_back({zero, along, 0, infinity}, zero);  // no length anywhere
  some.push_back({zero, along, 0, 1}, zero);         // pivot on an end, on the ray beyond either, within
  some.push_back({zero, along, 0, 1}, {1, 0, 0});
  some.push_back({zero, along, 0, 1}, {-1, 0, 0});
  some.push_back({zero, along, 0, 1}, {2, 0, 0});
  some.push_back({zero, along, 0, 1}, {0.5f, 0, 0});
  some.push_back({zero, along, 0, infinity}, {-1, 0, 0});
  some.push_back({zero, along, 0, largest}, {0.5f, 1, 0});
  some.push_back({zero, {3, 0, 4}, 0, 1}, {0, 1, 0});  // any length of the direction will do
  some.push_back({{1, 2, 3}, {0.6f, 0, 0.8f}, -1, 1}, {1, 2, 3});
  for (const float variate : {0.0f, 1e-7f, 0.5f, 1 - 0x1p-24f, 1.0f}) {
    const std::vector<float> u(none.size(), variate), v(some.size(), variate);
    const DistanceArrays nothing = sample(none, u), something = sample(some, v);
    for (std::size_t i = 0; i < u.size(); ++i) ASSERT_TRUE(nothing.t[i] == 0 && nothing.pdf[i] == 0) << i;
    expect_sane(some, v, something);
    for (std::size_t i = 0; i < v.size(); ++i) ASSERT_GT(something.pdf[i], 0) << i << " u " << variate;
  }
}

TEST_P(EquiangularContract, NoDensityOutside) {
  const SegmentArrays segments = mixed_segments(pose(), 20);
  const std::size_t n = segments.size();
  std::vector<float> t;
  for (std::size_t i = 0; i < n; ++i) t.push_back(std::nextafter(segments.t_min[i], -infinity));
  for (std::size_t i = 0; i < n; ++i) t.push_back(std::nextafter(segments.t_max[i], infinity));
  for (const float value : {nan, infinity, -infinity, largest, -largest}) t.insert(t.end(), n, value);
  for (const float density : pdf(segments, t)) ASSERT_EQ(density, 0);
  for (const auto& ends : {segments.t_min, segments.t_max}) {
    for (const float density : pdf(segments, ends)) ASSERT_GT(density, 0);
  }
}

TEST_P(EquiangularContract, PowersOfTwoScaleExactly) {
  const SegmentArrays segments = mixed_segments(pose(), 50);
  const std::vector<float> u = make_variates(segments.size()).u;
  const DistanceArrays expected = sample(segments, u);
  for (const float scale : {0x1p20f, 0x1p-20f}) {
    SegmentArrays scaled = segments;
    for (PointArrays* points : {&scaled.origin, &scaled.pivot}) {
      for (auto* axis : {&points->x, &points->y, &points->z})
        std::ranges::for_each(*axis, [&](float& x) { x *= scale; });
    }
    for (auto* ends : {&scaled.t_min, &scaled.t_max}) std::ranges::for_each(*ends, [&](float& x) { x *= scale; });
    const DistanceArrays got = sample(scaled, u);
    for (std::size_t i = 0; i < u.size(); ++i) {
      ASSERT_TRUE(same_bits(got.t[i], expected.t[i] * scale)) << i;
      ASSERT_TRUE(same_bits(got.pdf[i], expected.pdf[i] / scale)) << i;
    }
  }
}

TEST_P(EquiangularContract, EveryIsaHasTheSameBits) {
  const SegmentArrays segments = mixed_segments(pose(), 301);
  const std::vector<float> u = make_variates(3 * segments.size()).u;
  const DistanceArrays got = sample(segments, u);
  const std::vector<float> asked = pdf(segments, got.t);
  const ForcedIsa scalar(Isa::scalar);
  const DistanceArrays expected = sample(segments, u);
  const std::vector<float> expected_asked = pdf(segments, got.t);
  const std::uint32_t allowed = isa() == Isa::sse4_2 ? 1 : 0;  // its fma differs once in some 10^8
  for (std::size_t i = 0; i < u.size(); ++i) {
    ASSERT_LE(ulp_distance(got.t[i], expected.t[i]), allowed) << i;
    ASSERT_LE(ulp_distance(asked[i], expected_asked[i]), allowed) << i;
    if (same_bits(got.t[i], expected.t[i])) {
      ASSERT_LE(ulp_distance(got.pdf[i], expected.pdf[i]), allowed) << i;
    }
  }
}

TEST_P(EquiangularContract, BitsDoNotDependOnPlaceNumberOfSamplesOrThreads) {
  SegmentArrays all = mixed_segments(pose(), 41);
  const std::size_t n = all.size(), k = 3;
  for (std::size_t i = 5; i < n; i += 17) all.pivot.x[i] = nan;
  const std::vector<float> u = make_variates(k * n).u;
  const DistanceArrays expected = sample(all, u);
  for (const std::size_t grain : {std::size_t{0}, std::size_t{7}, std::size_t{1} << 20}) {
    const DistanceArrays got = sample(all, u, grain);
    ASSERT_EQ(first_difference(got.t, expected.t), k * n);
    ASSERT_EQ(first_difference(got.pdf, expected.pdf), k * n);
    ASSERT_EQ(first_difference(pdf(all, got.t, grain), pdf(all, got.t)), k * n);
  }
  std::vector<std::size_t> order = in_order(n);
  std::ranges::reverse(order);
  for (const std::size_t size : {n, std::size_t{17}, std::size_t{16}, std::size_t{15}, std::size_t{9}, std::size_t{7},
                                 std::size_t{1}, std::size_t{0}}) {
    order.resize(size);
    for (std::size_t j = 0; j < k; ++j) {  // a sample at a time
      std::vector<float> some;
      for (const std::size_t i : order) some.push_back(u[j * n + i]);
      const DistanceArrays got = sample(all.pick(order), some);
      const std::vector<float> asked = pdf(all.pick(order), got.t);
      for (std::size_t i = 0; i < size; ++i) {
        ASSERT_TRUE(same_bits(got.t[i], expected.t[j * n + order[i]])) << size << " " << i;
        ASSERT_TRUE(same_bits(got.pdf[i], expected.pdf[j * n + order[i]])) << size << " " << i;
        ASSERT_TRUE(same_bits(asked[i], got.pdf[i])) << size << " " << i;
      }
    }
  }
}

void expect_error(const std::function<void()>& call, const std::string& message) {
  try {
    call();
    ADD_FAILURE() << "no error, expected " << message;
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()).substr(0, message.size()), message);
  }
}

TEST_P(EquiangularContract, ErrorsNameTheSpanAndNothingIsWritten) {
  const SegmentArrays good = make_segments(Situation::ordinary, pose(), 4);
  const char* const names[] = {"segments.y", "segments.z", "segments.dx", "segments.dy",    "segments.dz",
                               "pivots.x",   "pivots.y",   "pivots.z",    "segments.t_min", "segments.t_max"};
  std::vector<float> u(8, 0.5f), t(8, -1), density(8, -1);
  for (std::size_t c = 0; c < 10; ++c) {
    SegmentArrays bad = good;
    columns(bad)[c + 1]->resize(3);
    const std::string message = std::string(names[c]) + ": has 3 elements, expected 4";
    expect_error([&] { equiangular::sample(bad.view(), bad.pivot.view(), u, t, density); }, message);
    expect_error([&] { parallel::equiangular::sample(bad.view(), bad.pivot.view(), u, t, density); }, message);
    expect_error([&] { equiangular::pdf(bad.view(), bad.pivot.view(), u, density); }, message);
  }
  const std::span<float> seven = std::span(t).first(7);
  const Segments s = good.view();
  const Points p = good.pivot.view();
  expect_error([&] { equiangular::sample(s, p, seven, t, density); },
               "u: has 7 elements, expected a multiple of the 4 segments");
  expect_error([&] { equiangular::sample(s, p, u, seven, density); }, "t: has 7 elements, expected 8");
  expect_error([&] { equiangular::sample(s, p, u, t, seven); }, "pdf: has 7 elements, expected 8");
  expect_error([&] { equiangular::pdf(s, p, seven, density); },
               "t: has 7 elements, expected a multiple of the 4 segments");
  expect_error([&] { equiangular::pdf(s, p, u, seven); }, "out: has 7 elements, expected 8");
  expect_error([&] { equiangular::sample({}, {}, u, t, density); },
               "u: has 8 elements, expected a multiple of the 0 segments");
  for (std::size_t i = 0; i < 8; ++i) EXPECT_TRUE(t[i] == -1 && density[i] == -1);
  equiangular::sample({}, {}, {}, {}, {});
  equiangular::sample(s, p, {}, {}, {});
}

HATBOX_FOR_EVERY_ISA_AND_POSE(EquiangularContract);

}  // namespace
}  // namespace hatbox::test
