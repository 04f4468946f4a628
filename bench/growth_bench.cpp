#include "growth_bench.h"

#include "arrays.h"
#include "measure.h"

#include <hatbox/hatbox.h>

#include <benchmark/benchmark.h>

#include <cstddef>
#include <thread>
#include <utility>

namespace hatbox::bench {
namespace {

constexpr std::size_t samples_in_cache = 16384;
constexpr Disk disk{{0, 0, 0}, {0, 0, 1}, 1};
constexpr Rectangle rectangle{{-0.5f, -0.5f, 0}, {1, 0, 0}, {0, 1, 0}};

template <class Light, class Map>
void add(std::vector<Case>& cases, Case c, Isa isa, const Light& light, Map map) {
  c.isa = name(isa);
  c.workload = growth;
  benchmark::RegisterBenchmark(c.name().c_str(), [=](benchmark::State& state) {
    measure_map(state, c, isa, light, map);
  })->UseRealTime();
  cases.push_back(c);
}

void add_maps(std::vector<Case>& cases, Case c, Isa isa) {
  c.light = "disk";
  c.map = "area";
  add(cases, c, isa, disk, DiskMap::area);
  c.map = "ld_radial";
  add(cases, c, isa, disk, DiskMap::ld_radial);
  c.light = "rectangle";
  c.map = "area";
  add(cases, c, isa, rectangle, RectangleMap::area);
  c.map = "spherical";
  add(cases, c, isa, rectangle, RectangleMap::spherical);
}

}  // namespace

std::vector<Case> register_growth_cases() {
  std::vector<Case> cases;
  for (const Isa isa : available_isas()) {
    for (std::size_t k = 1; k <= 64; k *= 2) {
      add_maps(cases, {.samples_per_point = k, .points = samples_in_cache / k}, isa);
    }
    if (is_slow(isa)) continue;
    const auto most = static_cast<int>(std::thread::hardware_concurrency());
    for (int threads = 1; threads <= most; threads *= 2) {
      add_maps(cases, {.threads = threads, .points = points_in_memory}, isa);
    }
  }
  return cases;
}

}  // namespace hatbox::bench
