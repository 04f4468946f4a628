// Packets of a kernel's arrays: whole ones, two at a time where there are registers for both; and all others, the last,
// partial one and points that lie apart, which go through the same vector code.
#pragma once

#include "kernel_table.h"
#include "lanes.h"
#include "twin.h"

namespace hatbox::HATBOX_ISA {
namespace {

/// Where a packet lies in the arrays.
template <class V>
struct WholePacket {
  using Vector = V;
  static constexpr bool whole = true;
  V load(const float* from) const { return hatbox::HATBOX_ISA::load(from, V()); }
  void store(float* to, V value) const { hatbox::HATBOX_ISA::store(to, value); }
};

/// Whole or partial, in a row or apart, as it turns out: one text for all, where speed does not matter as much as the
/// size of the code.
template <class V>
struct AnyPacket {
  using Vector = V;
  static constexpr bool whole = false;

  /// Where a lane lies, from where the packet does.
  std::size_t place(std::size_t lane) const { return offset == nullptr ? lane : offset[lane]; }

  V load(const float* from) const {
    if (count == lanes<V>) {
      return offset == nullptr ? hatbox::HATBOX_ISA::load(from, V()) : load_listed(from, offset, V());
    }
    float padded[lanes<V>] = {};
    for (std::size_t lane = 0; lane < count; ++lane) padded[lane] = from[place(lane)];
    return hatbox::HATBOX_ISA::load(padded, V());
  }
  void store(float* to, V value) const {
    if (count == lanes<V>) {
      return offset == nullptr ? hatbox::HATBOX_ISA::store(to, value) : store_listed(to, offset, value);
    }
    float padded[lanes<V>];
    hatbox::HATBOX_ISA::store(padded, value);
    for (std::size_t lane = 0; lane < count; ++lane) to[place(lane)] = padded[lane];
  }

  std::size_t count;
  const std::uint32_t* offset;  // null: its lanes lie in a row
};

template <class Memory>
using VectorOf = typename std::remove_cvref_t<Memory>::Vector;

// Two packets at a time hide latencies where there are registers for both: with 32 of them, not with 16.
#if defined(HATBOX_ISA_ARCH) && (defined(__AVX512F__) || defined(__aarch64__))
using WidePacket = Twin<Packet>;
#else
using WidePacket = Packet;
#endif

/// Calls body(packet, where it lies) for all packets of a list, one kind of packet at a time. For queries.
template <class Body>
HATBOX_INLINE inline void for_each_narrow_packet(const PointList& list, const Body& body) {
  for (std::size_t i = 0; i < list.count; i += lanes<Packet>) {
    const std::size_t left = list.count - i, count = left < lanes<Packet> ? left : lanes<Packet>;
    if (list.offset == nullptr) {
      body(AnyPacket<Packet>{count, nullptr}, list.first + i);
    } else {
      body(AnyPacket<Packet>{count, list.offset + i}, list.first);
    }
  }
}

/// The same as fast as can be, for points in a row: as many lanes at a time as there are registers for. Returns how
/// many points the whole packets were.
template <class Body>
HATBOX_INLINE inline std::size_t for_each_wide_packet(std::size_t first, std::size_t count, const Body& body) {
  std::size_t i = 0;
  for (; count - i >= lanes<WidePacket>; i += lanes<WidePacket>) body(WholePacket<WidePacket>(), first + i);
  return i;
}

/// All packets of a range, whole ones first.
template <class Body>
HATBOX_INLINE inline void for_each_packet(std::size_t begin, std::size_t end, const Body& body) {
  const std::size_t done = for_each_wide_packet(begin, end - begin, body);
  if constexpr (lanes < WidePacket >> 1) {
    for_each_narrow_packet(PointList{begin + done, end - begin - done, nullptr}, body);
  }
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
