#include "light_set_bench.h"

#include "arrays.h"

#include <hatbox/hatbox.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>

namespace hatbox::bench {
namespace {

constexpr std::size_t points = points_in_cache;

/// As many lights of each kind as of the others, or one disk: anywhere and any way round among the points of W1, and
/// from 0.1 to 1 in size.
struct Lights {
  explicit Lights(std::size_t count) {
    Random random;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 center{random(-3, 3), random(-3, 3), random(0, 3)};
      const float z = random(-1, 1), ring = std::sqrt(1 - z * z), phi = random(0, 6.28f), size = random(0.1f, 1);
      const Vec3 normal{ring * std::cos(phi), ring * std::sin(phi), z};
      const Vec3 u{-size * std::sin(phi), size * std::cos(phi), 0};
      const Vec3 v{normal.y * u.z - normal.z * u.y, normal.z * u.x - normal.x * u.z, normal.x * u.y - normal.y * u.x};
      if (i % 4 == 0) disks.push_back({center, normal, size});
      if (i % 4 == 1) ellipses.push_back({center, u, {0.6f * v.x, 0.6f * v.y, 0.6f * v.z}});
      if (i % 4 == 2) rectangles.push_back({center, u, v});
      if (i % 4 == 3)
        triangles.push_back({center,
                             {center.x + u.x, center.y + u.y, center.z + u.z},
                             {center.x + v.x, center.y + v.y, center.z + v.z}});
    }
  }

  LightSet set(const LightSet::Maps& maps) const { return {disks, ellipses, rectangles, triangles, maps}; }

  std::vector<Disk> disks;
  std::vector<Ellipse> ellipses;
  std::vector<Rectangle> rectangles;
  std::vector<Triangle> triangles;
};

constexpr LightSet::Maps best = {};
constexpr LightSet::Maps area = {DiskMap::area, EllipseMap::area, RectangleMap::area, TriangleMap::area};

/// A light for each point, at random.
std::vector<std::uint32_t> choices(std::size_t lights) {
  Random random;
  std::vector<std::uint32_t> chosen;
  for (std::size_t i = 0; i < points; ++i) {
    chosen.push_back(static_cast<std::uint32_t>(random(0, 1) * static_cast<float>(lights)));
  }
  return chosen;
}

struct Scene {
  Scene(std::size_t count, std::size_t k)
      : lights(count),
        best_set(lights.set(best)),
        area_set(lights.set(area)),
        chosen(choices(count)),
        arrays(points, k) {}

  void sample_set(const LightSet& set) {
    hatbox::sample(set, chosen, arrays.points(), arrays.variates(), arrays.samples(), workspace);
  }

  /// All points with one light, then all of them with the next.
  void sample_singly() {
    const auto each = [&](const auto& some, auto map) {
      for (const auto& light : some) {
        hatbox::sample(light, map, arrays.points(), arrays.variates(), arrays.samples());
        benchmark::ClobberMemory();
      }
    };
    each(lights.disks, best.disk);
    each(lights.ellipses, best.ellipse);
    each(lights.rectangles, best.rectangle);
    each(lights.triangles, best.triangle);
  }

  Lights lights;
  LightSet best_set, area_set;
  std::vector<std::uint32_t> chosen;
  Arrays arrays;
  Workspace workspace;
};

/// Made when it is first asked for, and shared by all cases.
Scene& scene(std::size_t lights, std::size_t k) {
  static std::map<std::pair<std::size_t, std::size_t>, std::unique_ptr<Scene>> all;
  std::unique_ptr<Scene>& one = all[{lights, k}];
  if (!one) one = std::make_unique<Scene>(lights, k);
  return *one;
}

struct Size {
  const char* workload;
  std::size_t lights, samples_per_point;
  bool with_single_calls = false;
};

constexpr Size sizes[] = {{"mixed", 1, 1, true}, {"mixed", 64, 1, true}, {"mixed", 64, 16, true}, {"mixed", 4096, 1},
                          {"mixed", 1000000, 1}, {growth, 1, 1},         {growth, 4, 1},          {growth, 16, 1},
                          {growth, 64, 1},       {growth, 256, 1},       {growth, 4096, 1},       {growth, 65536, 1},
                          {growth, 1000000, 1}};

void add(std::vector<Case>& cases, const Case& c, Isa isa, const std::function<void()>& work) {
  benchmark::RegisterBenchmark(c.name().c_str(), [isa, work](benchmark::State& state) {
    force_isa(isa);
    work();  // which makes the scene: in the first measured one it would pass for all there is time for
    for ([[maybe_unused]] auto _ : state) {
      work();
      benchmark::ClobberMemory();
    }
  })->UseRealTime();
  cases.push_back(c);
}

}  // namespace

std::vector<Case> register_light_set_cases() {
  std::vector<Case> cases;
  for (const Size& size : sizes) {
    const std::size_t count = size.lights, k = size.samples_per_point;
    for (const Isa isa : available_isas()) {
      const auto named = [&](const char* map, std::size_t n) {
        return Case{.light = "set_" + std::to_string(count),
                    .map = map,
                    .isa = name(isa),
                    .workload = size.workload,
                    .samples_per_point = k,
                    .points = n};
      };
      const auto get = [count, k]() -> Scene& { return scene(count, k); };
      add(cases, named("area", points), isa, [get] { get().sample_set(get().area_set); });
      add(cases, named("best", points), isa, [get] { get().sample_set(get().best_set); });
      if (size.with_single_calls)
        add(cases, named(single_calls, points * count), isa, [get] { get().sample_singly(); });
    }
  }
  return cases;
}

}  // namespace hatbox::bench
