// The loops of the media kit: packets of segments in, distances along them or parts of them out. What a segment takes
// to set up serves its k samples.
#pragma once

#include "equiangular_map.h"
#include "kernel_table.h"
#include "packets.h"
#include "segment_clip.h"

namespace hatbox::HATBOX_ISA {
namespace {

template <class V>
struct SegmentAndPlace {
  Ray<V> ray;
  V place[3];
};

template <class Memory>
HATBOX_INLINE inline auto load_segment(const SegmentJob& job, const Memory& memory, std::size_t i) {
  SegmentAndPlace<VectorOf<Memory>> result;
  for (int axis = 0; axis < 3; ++axis) {
    result.ray.origin[axis] = memory.load(job.origin[axis] + i);
    result.ray.direction[axis] = memory.load(job.direction[axis] + i);
    result.place[axis] = memory.load(job.place[axis] + i);
  }
  result.ray.t_min = memory.load(job.t_min + i);
  result.ray.t_max = memory.load(job.t_max + i);
  return result;
}

void equiangular_sample(const SegmentJob& shared_job, std::size_t begin, std::size_t end) {
  const SegmentJob job = shared_job;  // our own copy, which no store through an output can change
  for_each_packet(begin, end, [&](const auto& memory, std::size_t i) HATBOX_INLINE {
    using V = VectorOf<decltype(memory)>;
    const auto segment = load_segment(job, memory, i);
    const EquiangularMap<V> map(segment.ray, segment.place);
    for (std::size_t j = 0; j < job.samples_per_segment; ++j) {
      const std::size_t at = j * job.segments + i;
      const DistanceSample<V> sample = map.sample(memory.load(job.in + at));
      memory.store(job.out[0] + at, sample.t + V(0));  // + 0 makes 0 of −0
      memory.store(job.out[1] + at, sample.pdf);
    }
  });
}

void equiangular_pdf(const SegmentJob& shared_job, std::size_t begin, std::size_t end) {
  const SegmentJob job = shared_job;
  for_each_narrow_packet(begin, end, [&](const auto& memory, std::size_t i) HATBOX_INLINE {
    const auto segment = load_segment(job, memory, i);
    const EquiangularMap<VectorOf<decltype(memory)>> map(segment.ray, segment.place);
    for (std::size_t j = 0; j < job.samples_per_segment; ++j) {
      const std::size_t at = j * job.segments + i;
      memory.store(job.out[0] + at, map.pdf(memory.load(job.in + at)));
    }
  });
}

void clip_segments(const SegmentJob& shared_job, std::size_t begin, std::size_t end) {
  const SegmentJob job = shared_job;
  for_each_narrow_packet(begin, end, [&](const auto& memory, std::size_t i) HATBOX_INLINE {
    using V = VectorOf<decltype(memory)>;
    const auto segment = load_segment(job, memory, i);
    const V normal[3] = {memory.load(job.normal[0] + i), memory.load(job.normal[1] + i),
                         memory.load(job.normal[2] + i)};
    const Interval<V> lit = clip_to_front(segment.ray, segment.place, normal);
    memory.store(job.out[0] + i, lit.from + V(0));
    memory.store(job.out[1] + i, lit.to + V(0));
  });
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
