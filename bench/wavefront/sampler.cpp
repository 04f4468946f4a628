#include "sampler.h"

namespace wavefront {
namespace {

/// The finaliser of SplitMix64 (Steele, Lea and Flood 2014).
std::uint64_t mix(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

}  // namespace

std::uint64_t hash(std::uint64_t a, std::uint64_t b) {
  constexpr std::uint64_t golden_ratio = 0x9e3779b97f4a7c15;
  return mix(mix(a + golden_ratio) + (b + 1) * golden_ratio);
}

std::uint32_t shuffle_index(std::uint32_t index, int bits, std::uint64_t key) {
  std::uint32_t result = index;
  for (int bit = 0; bit < bits; ++bit) {
    const std::uint64_t block = (std::uint64_t{index} >> bit) >> 1;
    result ^= static_cast<std::uint32_t>(hash(key + static_cast<std::uint64_t>(bit), block) & 1) << bit;
  }
  return result;
}

Sampler::Sampler(SamplerKind kind, std::uint32_t count) : kind_(kind) {
  if (kind != SamplerKind::zero_two) return;
  sequence_.reserve(count);
  for (std::uint32_t index = 0; index < count; ++index) {
    Digits digits{0, 0};
    std::uint32_t column_x = 1u << 31;
    std::uint32_t column_y = 1u << 31;  // Sobol's second matrix is Pascal's triangle modulo 2 (Sobol' 1967)
    for (std::uint32_t rest = index; rest != 0; rest >>= 1) {
      if (rest & 1) {
        digits.x ^= column_x;
        digits.y ^= column_y;
      }
      column_x >>= 1;
      column_y ^= column_y >> 1;
    }
    sequence_.push_back(digits);
  }
}

}  // namespace wavefront
