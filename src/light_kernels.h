// The loops of a light's kernels: packets of points in, packets of results out. A packet's set-up (its cone, its
// series) is done once and serves the k samples of each of its points.
#pragma once

#include "compensated.h"
#include "kernel_table.h"
#include "light_sample.h"
#include "packet_lights.h"
#include "solid_angle.h"

namespace hatbox::HATBOX_ISA {
namespace {

template <class V, class Constants, class Memory>
HATBOX_INLINE inline void store_sample(const SampleJob<Constants>& job, const Memory& memory, std::size_t at,
                                       const LightSample<V>& sample) {
  const auto put = [&](float* to, V value) HATBOX_INLINE {
    // + 0 makes 0 of −0, whose sign a negation gives on some instruction sets and not on others.
    if (to != nullptr) memory.store(to + at, select(sample.valid, value + V(0), V(0)));
  };
  for (int axis = 0; axis < 3; ++axis) put(job.direction[axis], sample.direction[axis]);
  put(job.distance, sample.distance);
  put(job.pdf, sample.pdf);
  put(job.place[0], sample.place.s);
  put(job.place[1], sample.place.t);
  put(job.cosine, sample.cosine);
}

/// A map's set-up as a function of its own, for queries and remainders: its text is long, and compiling it into each of
/// their loops would take several times as long and gain little.
template <template <class> class Map, class Light, class V>
[[gnu::noinline]] Map<V> set_up(const Light& light, V x, V y, V z) {
  return Map<V>(light, x, y, z);
}

/// Of maps that say so themselves.
template <class Map>
inline constexpr bool is_cheap = requires {
  Map::is_cheap;
};

template <template <class> class Map, class Constants>
void sample(const SampleJob<Constants>& shared_job, std::size_t begin, std::size_t end) {
  const SampleJob<Constants> job = shared_job;  // our own copy, which no store through an output can change
  // `count` is a number or, where the loop is to vanish, a constant
  const auto sample_all = [&](const auto& map, const auto& memory, std::size_t i, auto count) HATBOX_INLINE {
    for (std::size_t j = 0; j < count; ++j) {
      const std::size_t at = j * job.points + i;
      store_sample(job, memory, at, map.sample(memory.load(job.u + at), memory.load(job.v + at)));
    }
  };
  const auto load = [&](const auto& memory, int axis, std::size_t i)
                        HATBOX_INLINE { return memory.load(job.point[axis] + i); };
  const std::size_t middle = end_of_whole_packets(begin, end);
  if (begin != middle) {
    PacketLights<WidePacket, Constants> lights(job.lights);
    const auto sample_packets = [&](const auto& lights_at, auto count) HATBOX_INLINE {
      for_each_whole_packet(begin, middle, [&](const auto& memory, std::size_t i) HATBOX_INLINE {
        const Map<WidePacket> map(lights_at(i), load(memory, 0, i), load(memory, 1, i), load(memory, 2, i));
        sample_all(map, memory, i, count);
      });
    };
    const auto gathered = [&](std::size_t i) HATBOX_INLINE -> const auto& { return lights.of(i, lanes<WidePacket>); };
    if constexpr (is_cheap<Map<WidePacket>>) {
      if (job.lights.index != nullptr) {
        sample_packets(gathered, job.samples_per_point);
      } else {
        const auto light = lights.of(begin, lanes<WidePacket>);  // our own too, to be kept in registers
        const auto same = [&](std::size_t) HATBOX_INLINE -> const auto& { return light; };
        if (job.samples_per_point == 1) {
          sample_packets(same, std::integral_constant<std::size_t, 1>());
        } else {
          sample_packets(same, job.samples_per_point);
        }
      }
    } else {
      sample_packets(gathered, job.samples_per_point);
    }
  }
  if (middle != end) {
    PacketLights<Packet, Constants> lights(job.lights);
    for_each_narrow_packet(middle, end, [&](const auto& memory, std::size_t i) HATBOX_INLINE {
      const auto map =
          set_up<Map>(lights.of(i, memory.count), load(memory, 0, i), load(memory, 1, i), load(memory, 2, i));
      sample_all(map, memory, i, job.samples_per_point);
    });
  }
}

/// The loop of the queries: answer(map, packet, at) for every query of every point, at the query's place in the arrays.
template <template <class> class Map, class Constants, class Answer>
HATBOX_INLINE inline void for_each_query(const QueryJob<Constants>& job, std::size_t begin, std::size_t end,
                                         const Answer& answer) {
  PacketLights<Packet, Constants> lights(job.lights);
  for_each_narrow_packet(begin, end, [&](const auto& memory, std::size_t i) HATBOX_INLINE {
    const auto map = set_up<Map>(lights.of(i, memory.count), memory.load(job.point[0] + i),
                                 memory.load(job.point[1] + i), memory.load(job.point[2] + i));
    for (std::size_t j = 0; j < job.queries_per_point; ++j) answer(map, memory, j * job.points + i);
  });
}

template <template <class> class Map, class Constants>
void pdf_of_direction(const QueryJob<Constants>& job, std::size_t begin, std::size_t end) {
  for_each_query<Map>(job, begin, end, [&](const auto& map, const auto& memory, std::size_t at) HATBOX_INLINE {
    using V = VectorOf<decltype(memory)>;
    const V direction[3] = {memory.load(job.query[0] + at), memory.load(job.query[1] + at),
                            memory.load(job.query[2] + at)};
    memory.store(job.out[0] + at, map.pdf_of_direction(direction));
  });
}

template <template <class> class Map, class Constants>
void pdf_of_place(const QueryJob<Constants>& job, std::size_t begin, std::size_t end) {
  for_each_query<Map>(job, begin, end, [&](const auto& map, const auto& memory, std::size_t at) HATBOX_INLINE {
    using V = VectorOf<decltype(memory)>;
    const Place<V> place = {memory.load(job.query[0] + at), memory.load(job.query[1] + at)};
    memory.store(job.out[0] + at, map.pdf_of_place(place));
  });
}

template <template <class> class Map, class Constants>
void invert(const QueryJob<Constants>& job, std::size_t begin, std::size_t end) {
  for_each_query<Map>(job, begin, end, [&](const auto& map, const auto& memory, std::size_t at) HATBOX_INLINE {
    using V = VectorOf<decltype(memory)>;
    const V direction[3] = {memory.load(job.query[0] + at), memory.load(job.query[1] + at),
                            memory.load(job.query[2] + at)};
    const Square<V> square = map.invert(direction);
    memory.store(job.out[0] + at, square.u);
    memory.store(job.out[1] + at, square.v);
  });
}

template <template <class> class Cone, class Constants>
void solid_angle(const QueryJob<Constants>& job, std::size_t begin, std::size_t end) {
  PacketLights<Packet, Constants> lights(job.lights);
  for_each_narrow_packet(begin, end, [&](const auto& memory, std::size_t i) HATBOX_INLINE {
    using V = VectorOf<decltype(memory)>;
    const Cone<V> cone(lights.of(i, memory.count), memory.load(job.point[0] + i), memory.load(job.point[1] + i),
                       memory.load(job.point[2] + i));
    const V area = solid_angle_of(cone);
    memory.store(job.out[0] + i, select(honest(cone.valid, area), area, V(0)));
  });
}

template <template <class> class Map, class Constants>
inline constexpr MapKernels<Constants> kernels_of = {sample<Map, Constants>, pdf_of_direction<Map, Constants>,
                                                     pdf_of_place<Map, Constants>, invert<Map, Constants>};

/// Of a map that has no inverse.
template <template <class> class Map, class Constants>
inline constexpr MapKernels<Constants> one_way_kernels_of = {sample<Map, Constants>, pdf_of_direction<Map, Constants>,
                                                             pdf_of_place<Map, Constants>, nullptr};

void product_residual(const float* x, const float* y, float* residual, std::size_t n) {
  for (std::size_t i = 0; i < n; i += lanes<Packet>) {
    store(residual + i, two_product(load(x + i, Packet()), load(y + i, Packet())).low);
  }
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
