// Blocks of points whose lights are of several kinds: they are brought into the order of the kinds, so that each kind's
// kernels see arrays as ever, and their results are brought back. A block of a single kind stays where it is.
#pragma once

#include "calls.h"
#include "light_set_data.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace hatbox {

/// One thread's scratch: a block in the order of its kinds.
class KindBlock {
 public:
  /// Enough points for every kind to fill its packets; few enough samples for their arrays to stay in the second-level
  /// cache. More samples a point than most_per_point are done in several goes, each with a set-up of its own.
  static constexpr std::size_t most_points = 1024, most_samples = 8192, most_per_point = 16;

  /// A multiple of the widest packet, so that blocks of one kind, which stay where they are, are whole packets;
  /// most_strides counts on it.
  static std::size_t points(std::size_t per_point) {
    const std::size_t room = most_samples / std::clamp<std::size_t>(per_point, 1, most_per_point);
    return std::min(most_points, room / widest_packet * widest_packet);
  }

  /// Calls run(kind, arrays, lights, begin, end) for each kind of light that points [begin, end) of a call have.
  template <class Run>
  void for_each_kind(const LightSet::Data& set, std::span<const std::uint32_t> light, const CallArrays& call,
                     std::size_t begin, std::size_t end, const Run& run) {
    const std::span<const std::uint32_t> lights = light.subspan(begin, end - begin);
    const std::optional<std::size_t> only = sort(set, lights);
    if (only) return run(*only, call, light.data(), begin, end);
    CallArrays block = points_of(call, begin, lights.size());
    for (std::size_t j = 0; j < call.size.per_point; j += most_per_point) {
      block.size.per_point = std::min(most_per_point, call.size.per_point - j);
      take(call, begin, lights.size(), j, block);
      std::size_t start = 0;
      for (std::size_t kind = 0; kind < light_kind_count; ++kind) {
        if (counts_[kind] != 0) run(kind, block, lights_.data(), start, start + counts_[kind]);
        start += counts_[kind];
      }
      give(call, begin, lights.size(), j, block);
    }
  }

 private:
  /// The kind of all the lights, if they are of one.
  std::optional<std::size_t> sort(const LightSet::Data& set, std::span<const std::uint32_t> lights);
  void place(std::span<const std::uint32_t> lights);
  CallArrays points_of(const CallArrays& call, std::size_t begin, std::size_t size);
  void take(const CallArrays& call, std::size_t begin, std::size_t size, std::size_t j, CallArrays& block);
  void give(const CallArrays& call, std::size_t begin, std::size_t size, std::size_t j, const CallArrays& block) const;

  /// From a sample of the block's points to the next: an odd number of cache lines, so that all of a packet's samples
  /// do not meet in the same few sets of the cache.
  static constexpr std::size_t stride_of(std::size_t size) { return ((size + 15) / 16 | 1) * 16; }

  template <class T, std::size_t size>
  using Array = std::array<T, size>;

  /// A stride is at most 16 more than the points of a full block, which are an even number of cache lines.
  static constexpr std::size_t most_strides = most_samples + 16 * most_per_point;

  Array<std::uint32_t, light_kind_count> counts_;
  Array<std::uint32_t, most_points> order_;   // of the points by kind: where in the block they were …
  Array<std::uint32_t, most_points> rank_;    // … and where each has gone
  Array<std::uint32_t, most_points> lights_;  // in that order
  Array<Array<float, most_points>, 3> point_;
  Array<Array<float, most_strides>, 3> in_;
  Array<Array<float, most_strides>, 8> out_;
};

}  // namespace hatbox
