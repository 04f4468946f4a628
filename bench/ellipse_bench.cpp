#include "ellipse_bench.h"

#include "arrays.h"

#include <hatbox/hatbox.h>

#include <benchmark/benchmark.h>

#include <map>
#include <memory>
#include <string>
#include <utility>

namespace hatbox::bench {
namespace {

constexpr Ellipse light{{0, 0, 0}, {1, 0, 0}, {0, 0.5f, 0}};
constexpr std::pair<const char*, EllipseMap> maps[] = {
    {"area", EllipseMap::area}, {"ld_radial", EllipseMap::ld_radial}, {"radial", EllipseMap::radial}};

/// Shared by all cases of a size, so that all of them see the same memory.
Arrays& arrays(const Case& c) {
  static std::map<std::pair<std::size_t, std::size_t>, std::unique_ptr<Arrays>> all;
  std::unique_ptr<Arrays>& one = all[{c.points, c.samples_per_point}];
  if (!one) one = std::make_unique<Arrays>(c.points, c.samples_per_point);
  return *one;
}

void measure(benchmark::State& state, const Case& c, Isa isa, EllipseMap map) {
  Arrays& a = arrays(c);
  force_isa(isa);
  for (auto _ : state) {
    sample(light, map, a.points(), a.variates(), a.samples());
    benchmark::ClobberMemory();
  }
}

}  // namespace

std::vector<Case> register_ellipse_cases() {
  std::vector<Case> cases;
  for (const std::size_t k : {std::size_t{1}, std::size_t{16}}) {
    for (const Isa isa : available_isas()) {
      for (const auto& [map_name, map] : maps) {
        const Case c{.light = "ellipse",
                     .map = map_name,
                     .isa = name(isa),
                     .workload = "W1",
                     .threads = 1,
                     .samples_per_point = k,
                     .points = 4096};
        benchmark::RegisterBenchmark(c.name().c_str(), [c, isa, map = map](benchmark::State& state) {
          measure(state, c, isa, map);
        })->UseRealTime();
        cases.push_back(c);
      }
    }
  }
  return cases;
}

}  // namespace hatbox::bench
