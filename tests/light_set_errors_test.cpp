// What a LightSet and its calls refuse, and what calls ask of memory.
#include "support/all_samplers.h"
#include "support/light_sets.h"
#include "support/workloads.h"

#include <hatbox/hatbox.h>

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <functional>
#include <limits>
#include <new>
#include <stdexcept>

// Under sanitizers memory is theirs to count.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define HATBOX_COUNTS_ALLOCATIONS
namespace {
std::atomic<std::size_t> allocations = 0;
void* counted(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
}  // namespace
void* operator new(std::size_t size) { return counted(size); }
void* operator new[](std::size_t size) { return counted(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
#endif

namespace hatbox::test {
namespace {

constexpr std::size_t n = 3000;

/// Arrays of the right length for every call, and all the calls.
struct Arguments {
  MixedLights lights{Pose::canonical, 4};
  LightSet set = lights.set({});
  PointArrays points = make_points(Workload::w1, Pose::canonical, n);
  VariateArrays variates = make_variates(n);
  std::vector<std::uint32_t> chosen = random_choices(n, 16);
  SampleArrays samples{n}, asked{n};
  std::vector<float> u = std::vector<float>(n, SampleArrays::untouched), v = u;
  Workspace workspace;

  bool untouched() const {
    const auto is = [](float value) { return value == SampleArrays::untouched; };
    return std::ranges::all_of(samples.columns[0], is) && std::ranges::all_of(u, is) && std::ranges::all_of(v, is);
  }
};

using Call = std::function<void(Arguments&)>;

const Call calls[] = {
    [](Arguments& a) { sample(a.set, a.chosen, a.points.view(), a.variates.view(), a.samples.view(), a.workspace); },
    [](Arguments& a) { pdf(a.set, a.chosen, a.points.view(), a.asked.directions(), a.u, a.workspace); },
    [](Arguments& a) { pdf(a.set, a.chosen, a.points.view(), a.asked.places(), a.u, a.workspace); },
    [](Arguments& a) { invert(a.set, a.chosen, a.points.view(), a.asked.directions(), a.u, a.v, a.workspace); },
    [](Arguments& a) { solid_angle(a.set, a.chosen, a.points.view(), a.u, a.workspace); },
    [](Arguments& a) {
      parallel::sample(a.set, a.chosen, a.points.view(), a.variates.view(), a.samples.view(), a.workspace);
    },
    [](Arguments& a) { parallel::pdf(a.set, a.chosen, a.points.view(), a.asked.directions(), a.u, a.workspace); },
    [](Arguments& a) { parallel::pdf(a.set, a.chosen, a.points.view(), a.asked.places(), a.u, a.workspace); },
    [](Arguments& a) {
      parallel::invert(a.set, a.chosen, a.points.view(), a.asked.directions(), a.u, a.v, a.workspace);
    },
    [](Arguments& a) { parallel::solid_angle(a.set, a.chosen, a.points.view(), a.u, a.workspace); },
};

std::string message_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST(LightSetErrors, AnIndexOutOfRangeNamesItsPosition) {
  for (const Call& call : calls) {
    Arguments a;
    a.chosen[2000] = 16;
    a.chosen[2500] = std::numeric_limits<std::uint32_t>::max();
    EXPECT_EQ(message_of([&] { call(a); }), "light[2000]: 16 is out of range, the set has 16 lights");
    EXPECT_TRUE(a.untouched());
  }
}

TEST(LightSetErrors, TooFewIndices) {
  for (const Call& call : calls) {
    Arguments a;
    a.chosen.pop_back();
    EXPECT_EQ(message_of([&] { call(a); }), "light: has 2999 elements, expected 3000");
    EXPECT_TRUE(a.untouched());
  }
}

TEST(LightSetErrors, AnEmptySetHasNoLights) {
  const LightSet none({}, {}, {}, {});
  EXPECT_EQ(none.size(), 0u);
  Workspace workspace;
  std::vector<float> omega;
  solid_angle(none, {}, {}, omega, workspace);
  Arguments a;
  a.set = none;
  EXPECT_NE(message_of([&] { calls[0](a); }).find("the set has 0 lights"), std::string::npos);
}

TEST(LightSetErrors, ABadLightIsNamed) {
  std::vector<Disk> disks(3, {{0, 0, 0}, {0, 0, 1}, 1});
  disks[2].radius = -1;
  EXPECT_EQ(message_of([&] { LightSet(disks, {}, {}, {}); }).find("disks[2]: light.radius is not positive"), 0u);
  const Triangle line[] = {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}};
  EXPECT_EQ(message_of([&] { LightSet({}, {}, {}, line); }).find("triangles[0]: light.a, b and c"), 0u);
}

TEST(LightSetErrors, AMapThatIsNone) {
  EXPECT_EQ(message_of([] { LightSet({}, {}, {}, {}, {.disk = static_cast<DiskMap>(7)}); }),
            "maps.disk: there is no map 7");
  EXPECT_EQ(message_of([] { LightSet({}, {}, {}, {}, {.triangle = static_cast<TriangleMap>(2)}); }),
            "maps.triangle: there is no map 2");
}

TEST(LightSetErrors, RejectionHasNoInverse) {
  Arguments a;
  a.set = a.lights.set({.disk = DiskMap::rejection});
  EXPECT_EQ(message_of([&] { calls[3](a); }), "set: DiskMap::rejection has no inverse");
  EXPECT_TRUE(a.untouched());
  const LightSet without_disks({}, a.lights.ellipses, {}, {}, {.disk = DiskMap::rejection});
  a.set = without_disks;
  a.chosen.assign(n, 1);
  EXPECT_NO_THROW(calls[3](a));
}

#ifdef HATBOX_COUNTS_ALLOCATIONS
/// But for the first of them.
TEST(LightSetMemory, SequentialCallsAllocateNothing) {
  Arguments a;
  calls[0](a);
  const std::size_t before = allocations;
  for (int again = 0; again < 3; ++again) {
    sample(a.set, a.chosen, a.points.view(), a.variates.view(), a.samples.view(), a.workspace);
    pdf(a.set, a.chosen, a.points.view(), a.asked.directions(), a.u, a.workspace);
    pdf(a.set, a.chosen, a.points.view(), a.asked.places(), a.u, a.workspace);
    invert(a.set, a.chosen, a.points.view(), a.asked.directions(), a.u, a.v, a.workspace);
    solid_angle(a.set, a.chosen, a.points.view(), a.u, a.workspace);
  }
  EXPECT_EQ(allocations, before);
}

TEST(LightMemory, SequentialCallsAllocateNothing) {
  const PointArrays points = make_points(Workload::w1, Pose::canonical, n);
  const VariateArrays variates = make_variates(n);
  SampleArrays samples(n);
  std::vector<float> u(n), v(n);
  for (const Sampler& sampler : all_samplers(Pose::canonical)) {
    SCOPED_TRACE(sampler.name);
    const Directions directions = {samples.columns[0], samples.columns[1], samples.columns[2]};
    const Places places = {samples.columns[SampleArrays::s], samples.columns[SampleArrays::t]};
    const std::size_t before = allocations;
    sampler.sample(points.view(), variates.view(), samples.view(), {});
    sampler.pdf_of_direction(points.view(), directions, u, {});
    sampler.pdf_of_place(points.view(), places, u, {});
    if (sampler.invert) sampler.invert(points.view(), directions, u, v, {});
    sampler.solid_angle(points.view(), u, {});
    EXPECT_EQ(allocations, before);
  }
}
#endif

}  // namespace
}  // namespace hatbox::test
