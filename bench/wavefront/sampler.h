// Sample points of the unit square, a set a pixel: a scrambled (0,2)-sequence or plain random numbers.
#pragma once

#include <cstdint>
#include <vector>

namespace wavefront {

enum class SamplerKind { zero_two, random };

struct Sample2 {
  float x, y;  // in [0, 1)
};

/// Mixes two numbers into 64 well-spread bits.
std::uint64_t hash(std::uint64_t a, std::uint64_t b);

/// Permutes 0 … 2^bits − 1 such that aligned blocks of 2^j indices stay aligned blocks, for every j.
std::uint32_t shuffle_index(std::uint32_t index, int bits, std::uint64_t key);

/// The first `count` points of a sequence, for any number of keys; a key is a pixel's (or a light's) own randomisation.
///
/// zero_two: van der Corput's sequence and the second dimension of Sobol's. Any 2^m points from an index that is a
/// multiple of 2^m are a (0,m,2)-net: one point in every box of area 2^-m whose sides are powers of two. The key flips
/// digits at random (XOR), which keeps that and makes each point uniform: every estimate is unbiased over the keys.
class Sampler {
 public:
  Sampler(SamplerKind kind, std::uint32_t count);

  Sample2 operator()(std::uint64_t key, std::uint32_t index) const {
    const Digits digits = kind_ == SamplerKind::zero_two ? flip(sequence_[index], key) : split(hash(key, index));
    return {to_unit(digits.x), to_unit(digits.y)};
  }

 private:
  struct Digits {
    std::uint32_t x, y;
  };
  static Digits split(std::uint64_t bits) {
    return {static_cast<std::uint32_t>(bits), static_cast<std::uint32_t>(bits >> 32)};
  }
  static Digits flip(Digits digits, std::uint64_t key) {
    const Digits mask = split(key);
    return {digits.x ^ mask.x, digits.y ^ mask.y};
  }
  // 24 bits, so that the last point does not round up to 1.
  static float to_unit(std::uint32_t digits) { return static_cast<float>(digits >> 8) * 0x1p-24f; }

  SamplerKind kind_;
  std::vector<Digits> sequence_;
};

}  // namespace wavefront
