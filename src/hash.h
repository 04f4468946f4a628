// Random numbers without a state: the bits of a lane's variates and a counter, hashed.
#pragma once

#include "unit_square.h"

#include <bit>
#include <cstdint>

namespace hatbox::HATBOX_ISA {
namespace {

/// A permutation of the 32-bit numbers in which every bit of the argument stirs every bit of the result (Wellons 2018,
/// "lowbias32").
inline std::uint32_t stirred(std::uint32_t x) {
  x = (x ^ (x >> 16)) * 0x7feb352du;
  x = (x ^ (x >> 15)) * 0x846ca68bu;
  return x ^ (x >> 16);
}

/// A point of the unit square. Integers lane by lane: a loop that the compiler turns into vectors, without another
/// vector type in the vocabulary of simd.h.
template <class V>
HATBOX_INLINE inline Square<V> hash_of(V u, V v, int counter) {
  constexpr std::size_t count = Lanes<V>::count;
  Scalar<V> first[count], second[count];
  store(first, u);
  store(second, v);
  for (std::size_t i = 0; i < count; ++i) {
    const auto bits = [](Scalar<V> x) { return std::bit_cast<std::uint32_t>(static_cast<float>(x)); };
    const std::uint32_t seed = stirred(bits(first[i]) + static_cast<std::uint32_t>(counter) * 0x9e3779b9u);
    const std::uint32_t one = stirred(seed ^ bits(second[i])), two = stirred(one ^ seed);
    const auto unit = [](std::uint32_t x) {
      return static_cast<Scalar<V>>(static_cast<std::int32_t>(x >> 8)) * Scalar<V>(0x1p-24);
    };
    first[i] = unit(one);
    second[i] = unit(two);
  }
  return {load(first, V()), load(second, V())};
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
