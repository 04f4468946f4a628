#include "disk_bench.h"

#include "arrays.h"
#include "measure.h"
#include "reference/disk_reference.h"
#include "reference/paper_table.h"

#include <hatbox/hatbox.h>

#include <benchmark/benchmark.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <map>
#include <string>
#include <utility>

namespace hatbox::bench {
namespace {

constexpr Disk light{{0, 0, 0}, {0, 0, 1}, 1};
constexpr std::pair<const char*, DiskMap> maps[] = {{"area", DiskMap::area},
                                                    {"ld_radial", DiskMap::ld_radial},
                                                    {"radial", DiskMap::radial},
                                                    {"parallel", DiskMap::parallel},
                                                    {"rejection", DiskMap::rejection},
                                                    {"radial_carlson", DiskMap::radial_carlson},
                                                    {"parallel_carlson", DiskMap::parallel_carlson}};

Arrays& arrays(const Case& c) { return shared_arrays(c.points, c.samples_per_point); }

/// What no sampler can beat: the same arrays read and written by the library's memcpy. Each of the five outputs gets a
/// copy of one of the five inputs; of the points once for every sample, as the outputs are longer.
void copy(Arrays& arrays, std::size_t begin, std::size_t end) {
  const Samples out = arrays.samples();
  const Variates variates = arrays.variates();
  const Points points = arrays.points();
  const std::size_t n = arrays.point_count();
  constexpr std::size_t piece = 1024;  // a block of points at a time, as the samplers do
  for (std::size_t i = begin; i < end; i += piece) {
    const std::size_t bytes = std::min(piece, end - i) * sizeof(float);
    for (std::size_t at = i; at < arrays.sample_count(); at += n) {
      std::memcpy(&out.x[at], &points.x[i], bytes);
      std::memcpy(&out.y[at], &points.y[i], bytes);
      std::memcpy(&out.z[at], &points.z[i], bytes);
      std::memcpy(&out.distance[at], &variates.u[at], bytes);
      std::memcpy(&out.pdf[at], &variates.v[at], bytes);
    }
  }
}

void copy_all(Arrays& arrays, bool parallel) {
  const std::size_t n = arrays.point_count();
  if (!parallel) return copy(arrays, 0, n);
  constexpr std::size_t block = 1024;
  tbb::parallel_for(std::size_t{0}, (n + block - 1) / block,
                    [&](std::size_t i) { copy(arrays, i * block, std::min(n, (i + 1) * block)); });
}

const DiskTable& table_of(std::size_t resolution) {
  static std::map<std::size_t, DiskTable> all;
  return all.try_emplace(resolution, DiskMap::ld_radial, resolution).first->second;
}

/// The paper's own way, a sample at a time in double: eq. 19 by Boost.Math, inverted by Newton's method.
void measure_reference(benchmark::State& state, const Case& c, DiskMap map) {
  Arrays& a = arrays(c);
  const reference::DiskFrame<double> frame(light);
  for ([[maybe_unused]] auto _ : state) {
    for (std::size_t i = 0; i < a.point_count(); ++i) {
      const Points p = a.points();
      const reference::PaperDisk disk(frame, {p.x[i], p.y[i], p.z[i]});
      benchmark::DoNotOptimize(disk.sample(map, a.variates().u[i], a.variates().v[i]));
    }
  }
}

/// The paper's tabulated map: the solid angle by eq. 19, once for the samples of a point, and the samples by its table.
void measure_paper_table(benchmark::State& state, const Case& c) {
  static const reference::PaperTable table(1024);
  Arrays& a = arrays(c);
  const reference::DiskFrame<double> frame(light);
  const Points p = a.points();
  for ([[maybe_unused]] auto _ : state) {
    for (std::size_t i = 0; i < a.point_count(); ++i) {
      const reference::PaperDisk disk(frame, {p.x[i], p.y[i], p.z[i]});
      for (std::size_t at = i; at < a.sample_count(); at += a.point_count()) {
        benchmark::DoNotOptimize(table.sample(disk, a.variates().u[at], a.variates().v[at]));
      }
    }
  }
}

class Registry {
 public:
  template <class Measure>
  void add(Case c, Measure measure) {
    c.light = "disk";
    c.workload = "W1";
    benchmark::RegisterBenchmark(c.name().c_str(), [c, measure](benchmark::State& state) {
      measure(state, c);
    })->UseRealTime();
    cases.push_back(std::move(c));
  }

  std::vector<Case> cases;
};

/// The tables, 64² of which the first-level cache holds and 1024² as the paper has it, and the paper's own.
void register_tables(Registry& registry) {
  for (const std::size_t k : {std::size_t{1}, std::size_t{16}}) {
    for (const std::size_t resolution : {std::size_t{64}, std::size_t{1024}}) {
      for (const Isa isa : available_isas()) {
        const Case c{.map = "table_" + std::to_string(resolution),
                     .isa = name(isa),
                     .reference_map = "paper_table",
                     .samples_per_point = k,
                     .points = points_in_cache};
        registry.add(c, [isa, resolution](benchmark::State& state, const Case& now) {
          measure_map(state, now, isa, light, table_of(resolution));
        });
      }
    }
    registry.add({.map = "paper_table",
                  .isa = "reference",
                  .reference_map = "paper_table",
                  .samples_per_point = k,
                  .points = 256},
                 measure_paper_table);
  }
}

}  // namespace

std::vector<Case> register_disk_cases() {
  Registry registry;
  for (const std::size_t points : {std::size_t{16}, points_in_cache, points_in_memory}) {
    for (const std::size_t k : {std::size_t{1}, std::size_t{16}}) {
      for (const int threads : {1, 2}) {
        const Case base{.threads = threads, .samples_per_point = k, .points = points};
        Case copying = base;
        copying.map = "copy";
        copying.isa = "any";
        registry.add(copying, [](benchmark::State& state, const Case& c) {
          measure(state, c, [&](bool in_parallel) { copy_all(arrays(c), in_parallel); });
        });
        for (const Isa isa : available_isas()) {
          if (points == points_in_memory && is_slow(isa)) continue;
          for (const auto& [map_name, map] : maps) {
            Case c = base;
            c.map = map_name;
            c.isa = name(isa);
            registry.add(c, [isa, map = map](benchmark::State& state, const Case& now) {
              measure_map(state, now, isa, light, map);
            });
          }
        }
      }
    }
  }
  register_tables(registry);
  for (const auto& [map_name, map] : maps) {
    if (map == DiskMap::area || map == DiskMap::rejection) continue;
    const Case c{.map = map_name, .isa = "reference", .threads = 1, .samples_per_point = 1, .points = 256};
    registry.add(c, [map = map](benchmark::State& state, const Case& now) { measure_reference(state, now, map); });
  }
  return registry.cases;
}

}  // namespace hatbox::bench
