// The bits of a lane depend on its own point and variates alone: not on where it lies, on how many samples or packets
// or threads there are, nor on who else is calling.
#include "support/all_samplers.h"
#include "support/bits.h"
#include "support/isa_fixture.h"
#include "support/sampler_calls.h"

#include <hatbox/hatbox.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <thread>
#include <tuple>

namespace hatbox::test {
namespace {

/// Every instruction set, the lights at the origin and in a general pose.
class Independence : public IsaAndPoseTest {};

TEST_P(Independence, LengthOfTheNormalDoesNotMatter) {
  const Disk light = disk_in(pose());
  const PointArrays points = make_points(Workload::w1, pose(), 100);
  const Sampler given("given", light, DiskMap::ld_radial);
  const Queries queries = make_queries(given, points, 1);
  const auto expected = call_everything(given, queries);
  for (const float scale : {0x1p20f, 0x1p-100f, 0x1p100f}) {
    Disk longer = light;
    longer.normal = {scale * longer.normal.x, scale * longer.normal.y, scale * longer.normal.z};
    expect_same(call_everything(Sampler("longer", longer, DiskMap::ld_radial), queries), expected);
  }
}

/// W1 and W2 with bad points strewn in, so that lanes that end early share a packet with those that do not.
PointArrays mixed_points(Pose pose, std::size_t n) {
  PointArrays points = make_points(Workload::w1, pose, n);
  const PointArrays close = make_points(Workload::w2, pose, n);
  for (std::size_t i = 0; i < n; ++i) {
    if (i % 3 == 0) std::tie(points.x[i], points.y[i], points.z[i]) = std::tuple(close.x[i], close.y[i], close.z[i]);
    if (i % 17 == 5) points.x[i] = std::numeric_limits<float>::quiet_NaN();
  }
  return points;
}

TEST_P(Independence, BitsDoNotDependOnThePlaceInTheArray) {
  constexpr std::size_t n = 203;
  for (const Sampler& sampler : all_samplers(pose())) {
    SCOPED_TRACE(sampler.name);
    for (const std::size_t k : sample_counts) {
      const Queries all = make_queries(sampler, mixed_points(pose(), n), k);
      const auto expected = call_everything(sampler, all);
      std::vector<std::size_t> order(n);
      std::iota(order.begin(), order.end(), std::size_t{0});
      std::reverse(order.begin(), order.end());
      expect_same(call_everything(sampler, pick(all, order)), pick(expected, n, order));
      std::rotate(order.begin(), order.begin() + 5, order.end());
      expect_same(call_everything(sampler, pick(all, order)), pick(expected, n, order));
      for (const std::size_t size : odd_sizes) {
        order.resize(size);
        expect_same(call_everything(sampler, pick(all, order)), pick(expected, n, order));
      }
    }
  }
}

TEST_P(Independence, BitsDoNotDependOnTheNumberOfSamples) {
  constexpr std::size_t n = 203, k = 3;
  for (const Sampler& sampler : all_samplers(pose())) {
    SCOPED_TRACE(sampler.name);
    const Queries several = make_queries(sampler, mixed_points(pose(), n), k);
    const auto expected = call_everything(sampler, several);
    for (std::size_t j = 0; j < k; ++j) {
      for (const auto& [what, values] : call_everything(sampler, nth_samples(several, j))) {
        const auto& all = std::ranges::find(expected, what, &NamedColumn::name)->values;
        const std::span part = what == "solid_angle" ? std::span(all) : std::span(all).subspan(j * n, n);
        EXPECT_EQ(first_difference(values, part), n) << what << " of sample " << j;
      }
    }
  }
}

TEST_P(Independence, BitsDoNotDependOnThreadsAndPackets) {
  for (const Sampler& sampler : all_samplers(pose())) {
    SCOPED_TRACE(sampler.name);
    for (const std::size_t k : sample_counts) {
      const Queries queries = make_queries(sampler, mixed_points(pose(), 1031), k);
      const auto expected = call_everything(sampler, queries);
      constexpr std::size_t grains[] = {0, 7, 64, 1 << 20};
      for (const std::size_t grain : grains) {
        SCOPED_TRACE("grain " + std::to_string(grain));
        expect_same(call_everything(sampler, queries, grain), expected);
      }
    }
  }
}

/// Sequential calls from several threads at once, as a renderer with its own scheduler makes them.
TEST_P(Independence, BitsDoNotDependOnOtherCallers) {
  for (const Sampler& sampler : all_samplers(pose())) {
    const Queries queries = make_queries(sampler, mixed_points(pose(), 300), 1);
    const auto expected = call_everything(sampler, queries);
    std::array<std::vector<NamedColumn>, 4> got;
    std::vector<std::thread> callers;
    for (auto& columns : got) callers.emplace_back([&] { columns = call_everything(sampler, queries); });
    for (std::thread& caller : callers) caller.join();
    for (const auto& columns : got) expect_same(columns, expected);
  }
}

HATBOX_FOR_EVERY_ISA_AND_POSE(Independence);

}  // namespace
}  // namespace hatbox::test
