// A LightSet gives every point what the call for its light alone gives it, bit for bit, however the lights are mixed.
#include "kernel_table.h"
#include "support/isa_fixture.h"
#include "support/light_sets.h"
#include "support/sampler_calls.h"

#include <hatbox/hatbox.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace hatbox::test {
namespace {

// What a light costs in memory.
static_assert(sizeof(DiskConstants) <= 96 && sizeof(EllipseConstants) <= 96 && sizeof(RectangleConstants) <= 96 &&
              sizeof(TriangleConstants) <= 96);

constexpr LightSet::Maps best = {};
constexpr std::size_t more_than_two_blocks = 2500;

/// Points of all workloads, some of them hopeless.
PointArrays all_points(Pose pose, std::size_t n) {
  PointArrays all;
  for (const Workload workload : all_workloads) {
    const PointArrays some = make_points(workload, pose, n / 3);
    for (std::size_t i = 0; i < some.size(); ++i) all.push_back(some[i]);
  }
  constexpr float infinity = std::numeric_limits<float>::infinity();
  all.x[n / 6] = std::numeric_limits<float>::quiet_NaN();
  all.y[n / 5] = infinity;
  all.z[n / 4] = 3e38f;
  return all;
}

/// Of a set whose points have the lights `chosen`.
void expect_as_alone(const MixedLights& lights, const LightSet::Maps& maps, const std::vector<std::uint32_t>& chosen,
                     const PointArrays& points, std::size_t k, Grain grain = {}) {
  Sampler set = sampler_of(lights.set(maps), chosen);
  if (maps.disk == DiskMap::rejection) set.invert = nullptr;
  const Queries queries = make_queries(set, points, k);
  const std::vector<NamedColumn> got = call_everything(set, queries, grain);
  for (std::size_t light = 0; light < lights.size(); ++light) {
    std::vector<std::size_t> whose;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      if (chosen[i] == light) whose.push_back(i);
    }
    Sampler alone = lights.alone(light, maps);
    SCOPED_TRACE(alone.name);
    if (!set.invert) alone.invert = nullptr;
    expect_same(pick(got, points.size(), whose), call_everything(alone, pick(queries, whose)));
  }
}

class LightSetCalls : public IsaAndPoseTest {};

TEST_P(LightSetCalls, AreThoseOfTheLightsAlone) {
  const MixedLights lights(pose(), 16);
  const PointArrays points = all_points(pose(), more_than_two_blocks);
  const auto chosen = random_choices(points.size(), lights.size());
  for (const std::size_t k : {std::size_t{1}, std::size_t{3}}) expect_as_alone(lights, best, chosen, points, k);
}

/// More samples than a block takes at a time.
TEST_P(LightSetCalls, AreThoseOfTheLightsAloneForManySamples) {
  const MixedLights lights(pose(), 2);
  const PointArrays points = all_points(pose(), 600);
  expect_as_alone(lights, best, random_choices(points.size(), lights.size()), points, 37);
}

/// A block takes fewer points the more samples they have; what it has room for is close to what it takes.
TEST_P(LightSetCalls, AreThoseOfTheLightsAloneInFullBlocks) {
  const MixedLights lights(pose(), 1);
  for (std::size_t k = 9; k <= 16; ++k) {
    SCOPED_TRACE(k);
    const std::size_t full_block = 8192 / k;
    const PointArrays points = make_points(Workload::w1, pose(), full_block);
    expect_as_alone(lights, best, random_choices(points.size(), lights.size()), points, k);
  }
}

TEST_P(LightSetCalls, AreThoseOfTheLightsAloneForEveryMap) {
  const MixedLights lights(pose(), 2);
  const PointArrays points = all_points(pose(), 120);
  const auto chosen = random_choices(points.size(), lights.size());
  for (int disk = 0; disk <= static_cast<int>(DiskMap::parallel_carlson); ++disk) {
    const LightSet::Maps maps = {static_cast<DiskMap>(disk), static_cast<EllipseMap>(disk % 3),
                                 static_cast<RectangleMap>(disk % 3), static_cast<TriangleMap>(disk % 2)};
    SCOPED_TRACE("disk map " + std::to_string(disk));
    expect_as_alone(lights, maps, chosen, points, 3);
  }
}

TEST_P(LightSetCalls, AreThoseOfTheLightsAloneInParallel) {
  const MixedLights lights(pose(), 4);
  const PointArrays points = all_points(pose(), more_than_two_blocks);
  const auto chosen = random_choices(points.size(), lights.size());
  constexpr std::size_t grains[] = {0, 7, 64, 1 << 20};
  for (const std::size_t grain : grains) expect_as_alone(lights, best, chosen, points, 1, grain);
}

/// Nothing is sorted then, and kinds change from block to block.
TEST_P(LightSetCalls, AreThoseOfTheLightsAloneInARow) {
  const MixedLights lights(pose(), 1);
  const PointArrays points = all_points(pose(), 6000);
  std::vector<std::uint32_t> chosen;
  for (std::size_t i = 0; i < points.size(); ++i) chosen.push_back(static_cast<std::uint32_t>(i / 1500));
  expect_as_alone(lights, best, chosen, points, 1);
}

TEST_P(LightSetCalls, AreThoseOfTheLightsAloneForAFewPoints) {
  const MixedLights lights(pose(), 1);
  for (const std::size_t n : odd_sizes) {
    if (n == 0) continue;
    const PointArrays points = make_points(Workload::w1, pose(), n);
    expect_as_alone(lights, best, random_choices(n, lights.size()), points, 3);
  }
}

TEST_P(LightSetCalls, ServeAMillionLights) {
  constexpr std::size_t of_each_kind = 250000, n = 3000;
  const MixedLights lights(pose(), of_each_kind);
  const PointArrays points = make_points(Workload::w1, pose(), n);
  const auto chosen = random_choices(n, lights.size());
  const Sampler set = sampler_of(lights.set(best), chosen);
  const Queries queries = make_queries(set, points, 1);
  const std::vector<NamedColumn> got = call_everything(set, queries);
  for (std::size_t i = 0; i < n; i += 97) {
    const auto alone = call_everything(lights.alone(chosen[i], best), pick(queries, {i}));
    expect_same(pick(got, n, {i}), alone);
  }
}

HATBOX_FOR_EVERY_ISA_AND_POSE(LightSetCalls);

}  // namespace
}  // namespace hatbox::test
