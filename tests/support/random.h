// Random numbers that are the same on every platform: the engine is fixed by the standard, the distributions are ours.
#pragma once

#include <cstdint>
#include <random>

namespace hatbox::test {

class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}

  /// A multiple of 2^-24 in [0, 1).
  float unit_float() { return static_cast<float>(engine_() >> 8) * 0x1p-24f; }

  /// A multiple of 2^-32 in [0, 1).
  double unit() { return static_cast<double>(engine_()) * 0x1p-32; }

  double uniform(double low, double high) { return low + (high - low) * unit(); }
  double log_uniform(double low, double high);

 private:
  std::mt19937 engine_;
};

}  // namespace hatbox::test
