#include "triangle_bench.h"

#include "arrays.h"

#include <hatbox/hatbox.h>

#include <benchmark/benchmark.h>

#include <cstddef>
#include <map>
#include <memory>
#include <utility>

namespace hatbox::bench {
namespace {

constexpr Triangle light{{-0.5f, -0.25f, 0}, {0.5f, -0.25f, 0}, {-0.5f, 0.75f, 0}};
constexpr std::pair<const char*, TriangleMap> maps[] = {{"area", TriangleMap::area},
                                                        {"spherical", TriangleMap::spherical}};

/// Arrays are made once for each size and shared by all cases, so that all of them see the same memory.
Arrays& arrays(const Case& c) {
  static std::map<std::pair<std::size_t, std::size_t>, std::unique_ptr<Arrays>> all;
  std::unique_ptr<Arrays>& one = all[{c.points, c.samples_per_point}];
  if (!one) one = std::make_unique<Arrays>(c.points, c.samples_per_point);
  return *one;
}

}  // namespace

std::vector<Case> register_triangle_cases() {
  std::vector<Case> cases;
  for (const std::size_t k : {std::size_t{1}, std::size_t{16}}) {
    for (const Isa isa : available_isas()) {
      for (const auto& [map_name, map] : maps) {
        const Case c{.light = "triangle",
                     .map = map_name,
                     .isa = name(isa),
                     .workload = "W1",
                     .samples_per_point = k,
                     .points = 4096};
        benchmark::RegisterBenchmark(c.name().c_str(), [c, isa, map = map](benchmark::State& state) {
          Arrays& a = arrays(c);
          force_isa(isa);
          for (auto _ : state) {
            sample(light, map, a.points(), a.variates(), a.samples());
            benchmark::ClobberMemory();
          }
        })->UseRealTime();
        cases.push_back(c);
      }
    }
  }
  return cases;
}

}  // namespace hatbox::bench
