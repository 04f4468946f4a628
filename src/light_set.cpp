// The public calls for sets of lights.
#include "calls.h"
#include "dispatch.h"
#include "kind_blocks.h"

#include <hatbox/light_set.h>

#include <tbb/task_arena.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace hatbox {

/// A block a thread.
struct Workspace::Data {
  /// For as many threads as the caller's arena may have.
  void reserve(std::size_t threads) {
    while (blocks.size() < threads) blocks.push_back(std::make_unique<KindBlock>());
  }
  /// Of a thread of the arena, or of one that is in none.
  KindBlock& of(int thread) { return *blocks[static_cast<std::size_t>(std::max(thread, 0))]; }

  std::vector<std::unique_ptr<KindBlock>> blocks;
};

namespace {

using Indices = std::span<const std::uint32_t>;

/// Whose light each of the n points has.
void check_indices(const LightSet& set, Indices light, std::size_t points) {
  if (light.size() != points) {
    throw std::invalid_argument("light: has " + std::to_string(light.size()) + " elements, expected " +
                                std::to_string(points));
  }
  std::uint32_t largest = 0;
  for (const std::uint32_t index : light) largest = std::max(largest, index);
  if (light.empty() || largest < set.size()) return;
  const auto bad = std::ranges::find_if(light, [&](std::uint32_t index) { return index >= set.size(); });
  throw std::invalid_argument("light[" + std::to_string(bad - light.begin()) + "]: " + std::to_string(*bad) +
                              " is out of range, the set has " + std::to_string(set.size()) + " lights");
}

/// How many threads may come to work in the caller's arena: even in one for a single thread a worker joins it, whenever
/// someone enqueues a task there.
std::size_t arena_threads() { return static_cast<std::size_t>(std::max(tbb::this_task_arena::max_concurrency(), 2)); }

/// For all points of a call, a block and a kind at a time, calls run(lights, kernels of their map, kernel of their
/// solid angle, arrays, begin, end).
template <class Run>
void for_each_kind(Schedule schedule, const LightSet& set, Indices light, const CallArrays& call, Workspace& workspace,
                   const Run& run) {
  check_indices(set, light, call.size.points);
  const KernelTable& table = active_kernels();
  const std::size_t per_point = call.size.per_point, step = KindBlock::points(per_point);
  if (schedule.grain == 0) schedule.grain = step;
  schedule.parallel = schedule.parallel && call.size.points > block_size(schedule.grain, per_point);
  workspace.data().reserve(schedule.parallel ? arena_threads() : 1);
  const auto run_kind = [&](std::size_t kind, const CallArrays& arrays, const std::uint32_t* index, std::size_t begin,
                            std::size_t end) {
    set.data().visit(kind, table, index, [&](const auto& lights, const auto& kernels, auto solid_angle) {
      run(lights, kernels, solid_angle, arrays, begin, end);
    });
  };
  run_blocks(schedule, call.size.points, per_point, 0, [&](std::size_t begin, std::size_t end) {
    KindBlock& block = workspace.data().of(schedule.parallel ? tbb::this_task_arena::current_thread_index() : 0);
    for (std::size_t i = begin; i < end; i += step) {
      block.for_each_kind(set.data(), light, call, i, std::min(end, i + step), run_kind);
    }
  });
}

void call_sample(const Schedule& schedule, const LightSet& set, Indices light, const CallArrays& call,
                 Workspace& workspace) {
  for_each_kind(schedule, set, light, call, workspace,
                [](const auto& lights, const auto& kernels, auto, const CallArrays& arrays, std::size_t begin,
                   std::size_t end) { kernels.sample(sample_job(lights, arrays), begin, end); });
}

/// `kernel` picks a query's kernel from those of a map and that of the solid angle.
template <class Pick>
void call_query(const Schedule& schedule, const LightSet& set, Indices light, const CallArrays& call,
                Workspace& workspace, const Pick& kernel) {
  for_each_kind(
      schedule, set, light, call, workspace,
      [&](const auto& lights, const auto& kernels, auto solid_angle, const CallArrays& arrays, std::size_t begin,
          std::size_t end) { kernel(kernels, solid_angle)(query_job(lights, arrays), begin, end); });
}

void call_pdf(const Schedule& schedule, const LightSet& set, Indices light, const Points& points,
              const Directions& directions, std::span<float> out, Workspace& workspace) {
  call_query(schedule, set, light, checked_pdf(points, directions, out), workspace,
             [](const auto& kernels, auto) { return kernels.pdf_of_direction; });
}

void call_pdf(const Schedule& schedule, const LightSet& set, Indices light, const Points& points, const Places& places,
              std::span<float> out, Workspace& workspace) {
  call_query(schedule, set, light, checked_pdf(points, places, out), workspace,
             [](const auto& kernels, auto) { return kernels.pdf_of_place; });
}

void call_invert(const Schedule& schedule, const LightSet& set, Indices light, const Points& points,
                 const Directions& directions, std::span<float> u, std::span<float> v, Workspace& workspace) {
  if (!set.data().disks.empty() && set.data().maps.disk == DiskMap::rejection) {
    throw std::invalid_argument("set: DiskMap::rejection has no inverse");
  }
  call_query(schedule, set, light, checked_invert(points, directions, u, v), workspace,
             [](const auto& kernels, auto) { return kernels.invert; });
}

void call_solid_angle(const Schedule& schedule, const LightSet& set, Indices light, const Points& points,
                      std::span<float> out, Workspace& workspace) {
  call_query(schedule, set, light, checked_solid_angle(points, out), workspace,
             [](const auto&, auto solid_angle) { return solid_angle; });
}

}  // namespace

Workspace::Workspace() : data_(std::make_unique<Data>()) {}
Workspace::~Workspace() = default;
Workspace::Workspace(Workspace&&) noexcept = default;
Workspace& Workspace::operator=(Workspace&&) noexcept = default;

void sample(const LightSet& set, Indices light, Points points, Variates variates, Samples out, Workspace& workspace) {
  call_sample({}, set, light, checked_sample(points, variates, out), workspace);
}

void pdf(const LightSet& set, Indices light, Points points, Directions directions, std::span<float> out,
         Workspace& workspace) {
  call_pdf({}, set, light, points, directions, out, workspace);
}

void pdf(const LightSet& set, Indices light, Points points, Places places, std::span<float> out, Workspace& workspace) {
  call_pdf({}, set, light, points, places, out, workspace);
}

void invert(const LightSet& set, Indices light, Points points, Directions directions, std::span<float> u,
            std::span<float> v, Workspace& workspace) {
  call_invert({}, set, light, points, directions, u, v, workspace);
}

void solid_angle(const LightSet& set, Indices light, Points points, std::span<float> out, Workspace& workspace) {
  call_solid_angle({}, set, light, points, out, workspace);
}

namespace parallel {

void sample(const LightSet& set, Indices light, Points points, Variates variates, Samples out, Workspace& workspace,
            std::size_t grain) {
  call_sample(parallel_with(grain), set, light, checked_sample(points, variates, out), workspace);
}

void pdf(const LightSet& set, Indices light, Points points, Directions directions, std::span<float> out,
         Workspace& workspace, std::size_t grain) {
  call_pdf(parallel_with(grain), set, light, points, directions, out, workspace);
}

void pdf(const LightSet& set, Indices light, Points points, Places places, std::span<float> out, Workspace& workspace,
         std::size_t grain) {
  call_pdf(parallel_with(grain), set, light, points, places, out, workspace);
}

void invert(const LightSet& set, Indices light, Points points, Directions directions, std::span<float> u,
            std::span<float> v, Workspace& workspace, std::size_t grain) {
  call_invert(parallel_with(grain), set, light, points, directions, u, v, workspace);
}

void solid_angle(const LightSet& set, Indices light, Points points, std::span<float> out, Workspace& workspace,
                 std::size_t grain) {
  call_solid_angle(parallel_with(grain), set, light, points, out, workspace);
}

}  // namespace parallel
}  // namespace hatbox
