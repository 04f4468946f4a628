// How a job is spread over threads: in the caller's, or in blocks of points by TBB.
#pragma once

#include "kernel_table.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace hatbox {

struct Schedule {
  bool parallel = false;
  std::size_t grain = 0;  // points a block at least; 0: chosen here
};

inline Schedule parallel_with(std::size_t grain) { return {.parallel = true, .grain = grain}; }

/// Points a block, for k samples each: about what fits the first-level cache with its inputs and outputs and is worth a
/// task, or the grain, and a multiple of the widest packet, so that of a job only the last packets are partial ones.
inline std::size_t block_size(std::size_t grain, std::size_t per_point) {
  constexpr std::size_t samples_per_block = 1024;
  const std::size_t points = grain != 0 ? grain : samples_per_block / std::max<std::size_t>(per_point, 1);
  const std::size_t packets = points / widest_packet + (points % widest_packet != 0 ? 1 : 0);
  return std::max<std::size_t>(std::min(packets, SIZE_MAX / widest_packet), 1) * widest_packet;
}

/// Calls body(i) for all i of [first, last), in the caller's TBB arena and isolated from its other tasks, be they
/// cancelled. Denormals are flushed, or not, as in the caller's thread: TBB's have the modes of whoever happened to
/// make them.
template <class Body>
void for_each_in_parallel(std::size_t first, std::size_t last, const Body& body) {
  using Context = tbb::task_group_context;
  Context context(Context::isolated, Context::default_traits | Context::fp_settings);
  tbb::this_task_arena::isolate([&] { tbb::parallel_for(first, last, body, context); });
}

/// How many points come before the first whose result begins a cache line of the array, and with it all of its rows.
/// They are a piece of work of their own, so that the packets after them write whole lines: where the caches are too
/// small, half a line goes back to memory before the other half is written. 0 where that is not worth the while.
inline std::size_t points_before_line(const float* out, std::size_t points, std::size_t per_point) {
  constexpr std::size_t line = 64, floats = line / sizeof(float), least_points = 1024, least_samples = 32768;
  if (points < least_points || points * per_point < least_samples) return 0;
  if (per_point != 1 && points % floats != 0) return 0;  // each row begins elsewhere
  const std::size_t past = reinterpret_cast<std::uintptr_t>(out) % line;
  return (line - past) % line / sizeof(float);
}

/// Calls work(begin, end) for all of the points, the first `head` of them apart, in parallel in blocks; a job of one
/// block stays in the caller's thread.
template <class Work>
void run_blocks(const Schedule& schedule, std::size_t points, std::size_t per_point, std::size_t head,
                const Work& work) {
  const auto work_on = [&](std::size_t begin, std::size_t end) {
    if (begin == head && head != 0) work(std::size_t{0}, head);
    work(begin, end);
  };
  const std::size_t block = block_size(schedule.grain, per_point);
  if (!schedule.parallel || points <= block) {
    work_on(head, points);
    return;
  }
  const std::size_t blocks = (points - head + block - 1) / block;
  for_each_in_parallel(0, blocks, [&](std::size_t i) {
    const std::size_t begin = head + i * block;
    work_on(begin, std::min(points, begin + block));
  });
}

/// Runs a kernel over all of the points. `out` is one of its outputs, and like the others.
template <class Job>
void run(const Schedule& schedule, std::size_t points, std::size_t per_point,
         void (*kernel)(const Job&, std::size_t, std::size_t), const Job& job, const float* out) {
  run_blocks(schedule, points, per_point, points_before_line(out, points, per_point),
             [&](std::size_t begin, std::size_t end) { kernel(job, begin, end); });
}

}  // namespace hatbox
