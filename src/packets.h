// Packets of a kernel's arrays: whole ones, two at a time where there are registers for both, and the last, partial
// one, which goes through the same vector code.
#pragma once

#include "lanes.h"

#include <cstring>

namespace hatbox::HATBOX_ISA {
namespace {

/// Where a packet lies in the arrays: all of it, or its first `count` lanes.
template <class V>
struct WholePacket {
  using Vector = V;
  V load(const float* from) const { return hatbox::HATBOX_ISA::load(from, V()); }
  void store(float* to, V value) const { hatbox::HATBOX_ISA::store(to, value); }
};

/// Whole or partial, as it turns out: one text for both, where speed does not matter as much as the size of the code.
template <class V>
struct AnyPacket {
  using Vector = V;
  V load(const float* from) const {
    if (count == lanes<V>) return hatbox::HATBOX_ISA::load(from, V());
    float padded[lanes<V>] = {};
    std::memcpy(padded, from, count * sizeof(float));
    return hatbox::HATBOX_ISA::load(padded, V());
  }
  void store(float* to, V value) const {
    if (count == lanes<V>) return hatbox::HATBOX_ISA::store(to, value);
    float padded[lanes<V>];
    hatbox::HATBOX_ISA::store(padded, value);
    std::memcpy(to, padded, count * sizeof(float));
  }
  std::size_t count;
};

template <class Memory>
using VectorOf = typename std::remove_cvref_t<Memory>::Vector;

// Two packets at a time hide latencies, even where what they keep outgrows the registers. Not so with SSE4.2, whose
// fused multiply-add takes a dozen instructions.
#if defined(HATBOX_ISA_ARCH) && (defined(__AVX2__) || defined(__aarch64__))
using WidePacket = Twin<Packet>;
#else
using WidePacket = Packet;
#endif

/// Calls body(packet, first point) for all packets of [begin, end), one kind of packet at a time. For queries.
template <class Body>
HATBOX_INLINE inline void for_each_narrow_packet(std::size_t begin, std::size_t end, const Body& body) {
  for (std::size_t i = begin; i < end; i += lanes<Packet>) {
    const std::size_t left = end - i;
    body(AnyPacket<Packet>{left < lanes<Packet> ? left : lanes<Packet>}, i);
  }
}

/// Where the whole packets of [begin, end) end: as many lanes at a time as there are registers for.
inline std::size_t end_of_whole_packets(std::size_t begin, std::size_t end) {
  return end - (end - begin) % lanes<WidePacket>;
}

/// The same where there are whole packets alone, as fast as can be. For sampling.
template <class Body>
HATBOX_INLINE inline void for_each_whole_packet(std::size_t begin, std::size_t end, const Body& body) {
  for (std::size_t i = begin; i < end; i += lanes<WidePacket>) body(WholePacket<WidePacket>(), i);
}

/// Whole packets, and the rest in narrow ones.
template <class Body>
HATBOX_INLINE inline void for_each_packet(std::size_t begin, std::size_t end, const Body& body) {
  const std::size_t middle = end_of_whole_packets(begin, end);
  for_each_whole_packet(begin, middle, body);
  if constexpr (1 < lanes<WidePacket>) for_each_narrow_packet(middle, end, body);
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
