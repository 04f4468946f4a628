// Comparison of whole arrays of floats, bit by bit.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace hatbox::test {

inline bool same_bits(float a, float b) { return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b); }

/// The first place where two arrays differ in a bit, or their length if they do not.
inline std::size_t first_difference(std::span<const float> a, std::span<const float> b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (i >= b.size() || !same_bits(a[i], b[i])) return i;
  }
  return a.size();
}

}  // namespace hatbox::test
