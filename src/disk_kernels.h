// The loops of a kernel: packets of points in, packets of results out. A packet's set-up (its cone, its series) is done
// once and serves the k samples of each of its points. The last, partial packet goes through the same vector code.
#pragma once

#include "disk_area.h"
#include "disk_radial.h"
#include "solid_angle.h"
#include "twin.h"

namespace hatbox::HATBOX_ISA {
namespace {

template <class V>
inline constexpr std::size_t lanes = Lanes<V>::count;

/// Where a packet lies in the arrays: whole, or the first `count` lanes of it.
template <class V>
struct WholePacket {
  using Vector = V;
  V load(const float* from) const { return hatbox::HATBOX_ISA::load(from, V()); }
  void store(float* to, V value) const { hatbox::HATBOX_ISA::store(to, value); }
};

template <class V>
struct PartialPacket {
  using Vector = V;
  V load(const float* from) const {
    float padded[lanes<V>] = {};
    std::memcpy(padded, from, count * sizeof(float));
    return hatbox::HATBOX_ISA::load(padded, V());
  }
  void store(float* to, V value) const {
    float padded[lanes<V>];
    hatbox::HATBOX_ISA::store(padded, value);
    std::memcpy(to, padded, count * sizeof(float));
  }
  std::size_t count;
};

template <class Memory>
using VectorOf = typename std::remove_cvref_t<Memory>::Vector;

// Two packets at a time hide latencies where there are registers for both: with 32 of them, not with 16.
#if defined(HATBOX_ISA_ARCH) && (defined(__AVX512F__) || defined(__aarch64__))
using WidePacket = Twin<Packet>;
#else
using WidePacket = Packet;
#endif

/// Calls body(packet, first point) for all packets of [begin, end).
template <class Body>
HATBOX_INLINE inline void for_each_packet(std::size_t begin, std::size_t end, const Body& body) {
  std::size_t i = begin;
  if constexpr (!std::is_same_v<WidePacket, Packet>) {
    for (; end - i >= lanes<WidePacket>; i += lanes<WidePacket>) body(WholePacket<WidePacket>(), i);
  }
  for (; end - i >= lanes<Packet>; i += lanes<Packet>) body(WholePacket<Packet>(), i);
  if (i < end) body(PartialPacket<Packet>{end - i}, i);
}

template <class V, class Memory>
HATBOX_INLINE inline void store_sample(const DiskSampleJob& job, const Memory& memory, std::size_t at,
                                       const DiskSample<V>& sample) {
  const auto put = [&](float* to, V value) HATBOX_INLINE {
    if (to != nullptr) memory.store(to + at, select(sample.valid, value, V(0)));
  };
  for (int axis = 0; axis < 3; ++axis) put(job.direction[axis], sample.direction[axis]);
  put(job.distance, sample.distance);
  put(job.pdf, sample.pdf);
  put(job.place[0], sample.place.s);
  put(job.place[1], sample.place.t);
  put(job.cosine, sample.cosine);
}

template <template <class> class Map>
void disk_sample(const DiskSampleJob& shared_job, std::size_t begin, std::size_t end) {
  const DiskSampleJob job = shared_job;  // our own copy, which no store through an output can change
  for_each_packet(begin, end, [&](const auto& memory, std::size_t i) HATBOX_INLINE {
    using V = VectorOf<decltype(memory)>;
    const Map<V> map(job.light, memory.load(job.point[0] + i), memory.load(job.point[1] + i),
                     memory.load(job.point[2] + i));
    for (std::size_t j = 0; j < job.samples_per_point; ++j) {
      const std::size_t at = j * job.points + i;
      store_sample(job, memory, at, map.sample(memory.load(job.u + at), memory.load(job.v + at)));
    }
  });
}

/// The loop of the queries: answer(map, packet, at) for every query of every point, at the query's place in the arrays.
template <template <class> class Map, class Answer>
HATBOX_INLINE inline void for_each_query(const DiskQueryJob& job, std::size_t begin, std::size_t end,
                                         const Answer& answer) {
  for_each_packet(begin, end, [&](const auto& memory, std::size_t i) HATBOX_INLINE {
    using V = VectorOf<decltype(memory)>;
    const Map<V> map(job.light, memory.load(job.point[0] + i), memory.load(job.point[1] + i),
                     memory.load(job.point[2] + i));
    for (std::size_t j = 0; j < job.queries_per_point; ++j) answer(map, memory, j * job.points + i);
  });
}

template <template <class> class Map>
void disk_pdf_of_direction(const DiskQueryJob& job, std::size_t begin, std::size_t end) {
  for_each_query<Map>(job, begin, end, [&](const auto& map, const auto& memory, std::size_t at) HATBOX_INLINE {
    using V = VectorOf<decltype(memory)>;
    const V direction[3] = {memory.load(job.query[0] + at), memory.load(job.query[1] + at),
                            memory.load(job.query[2] + at)};
    memory.store(job.out[0] + at, map.pdf_of_direction(direction));
  });
}

template <template <class> class Map>
void disk_pdf_of_place(const DiskQueryJob& job, std::size_t begin, std::size_t end) {
  for_each_query<Map>(job, begin, end, [&](const auto& map, const auto& memory, std::size_t at) HATBOX_INLINE {
    using V = VectorOf<decltype(memory)>;
    const Place<V> place = {memory.load(job.query[0] + at), memory.load(job.query[1] + at)};
    memory.store(job.out[0] + at, map.pdf_of_place(place));
  });
}

template <template <class> class Map>
void disk_invert(const DiskQueryJob& job, std::size_t begin, std::size_t end) {
  for_each_query<Map>(job, begin, end, [&](const auto& map, const auto& memory, std::size_t at) HATBOX_INLINE {
    using V = VectorOf<decltype(memory)>;
    const V direction[3] = {memory.load(job.query[0] + at), memory.load(job.query[1] + at),
                            memory.load(job.query[2] + at)};
    const Square<V> square = map.invert(direction);
    memory.store(job.out[0] + at, square.u);
    memory.store(job.out[1] + at, square.v);
  });
}

void disk_solid_angle(const DiskQueryJob& job, std::size_t begin, std::size_t end) {
  for_each_packet(begin, end, [&](const auto& memory, std::size_t i) HATBOX_INLINE {
    using V = VectorOf<decltype(memory)>;
    const DiskCone<V> cone = disk_cone(job.light, memory.load(job.point[0] + i), memory.load(job.point[1] + i),
                                       memory.load(job.point[2] + i));
    const V area = spherical_ellipse_area(cone);
    memory.store(job.out[0] + i, select(honest(cone.valid, area), area, V(0)));
  });
}

void product_residual(const float* x, const float* y, float* residual, std::size_t n) {
  for (std::size_t i = 0; i < n; i += lanes<Packet>) {
    store(residual + i, two_product(load(x + i, Packet()), load(y + i, Packet())).low);
  }
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
