// Right-handed frames in any direction, to put lights into.
#pragma once

#include "reference/vector.h"
#include "support/random.h"

#include <hatbox/lights.h>

#include <cmath>
#include <numbers>

namespace hatbox::test {

inline Vec3 rounded(const reference::Vector<double>& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

struct Frame {
  reference::Vector<double> u{1, 0, 0}, v{0, 1, 0}, n{0, 0, 1};
};

inline Frame random_frame(Random& random) {
  const double z = random.uniform(-1, 1), ring = std::sqrt(1 - z * z), phi = 2 * std::numbers::pi * random.unit();
  const reference::Vector<double> n{ring * std::cos(phi), ring * std::sin(phi), z}, u{-std::sin(phi), std::cos(phi), 0};
  return {u, cross(n, u), n};
}

}  // namespace hatbox::test
