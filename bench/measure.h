// How a case is measured: in this thread, or in an arena of as many as it wants.
#pragma once

#include "arrays.h"
#include "report.h"

#include <hatbox/hatbox.h>

#include <tbb/task_arena.h>

namespace hatbox::bench {

/// Times work(in_parallel).
template <class Work>
void measure(benchmark::State& state, const Case& c, const Work& work) {
  tbb::task_arena arena(c.threads);
  arena.initialize();
  for ([[maybe_unused]] auto _ : state) {
    if (c.threads == 1) {
      work(false);
    } else {
      arena.execute([&] { work(true); });
    }
    benchmark::ClobberMemory();
  }
}

/// Times the samples of a light; `map` is one of its maps, or a table.
template <class Light, class Map>
void measure_map(benchmark::State& state, const Case& c, Isa isa, const Light& light, const Map& map) {
  Arrays& a = shared_arrays(c.points, c.samples_per_point);
  force_isa(isa);
  measure(state, c, [&](bool in_parallel) {
    if (in_parallel) {
      parallel::sample(light, map, a.points(), a.variates(), a.samples());
    } else {
      sample(light, map, a.points(), a.variates(), a.samples());
    }
  });
}

}  // namespace hatbox::bench
