// How a case is measured: in this thread, or in an arena of as many as it wants.
#pragma once

#include "report.h"

#include <tbb/task_arena.h>

namespace hatbox::bench {

/// Times work(in_parallel).
template <class Work>
void measure(benchmark::State& state, const Case& c, const Work& work) {
  tbb::task_arena arena(c.threads);
  arena.initialize();
  for (auto _ : state) {
    if (c.threads == 1) {
      work(false);
    } else {
      arena.execute([&] { work(true); });
    }
    benchmark::ClobberMemory();
  }
}

}  // namespace hatbox::bench
