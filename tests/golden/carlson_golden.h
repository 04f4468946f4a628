// The golden values that make_carlson_golden.py wrote.
#pragma once

#include <array>

namespace hatbox::test {

enum class Integral { rf, rc, rd, rj, f, e, pi };

struct GoldenIntegral {
  Integral integral;
  std::array<float, 4> arguments;  // as many as it has, in the order of the call; then 0
  double value;
};

inline constexpr GoldenIntegral golden_carlson[] = {
#include "golden/carlson.inc"
};

inline constexpr GoldenIntegral golden_legendre[] = {
#include "golden/ellint.inc"
};

}  // namespace hatbox::test
