// From the unit square to the unit disk, as the library promises it (disk.h), in double.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hatbox::reference {

/// Variates are clamped into [0, 1).
inline double clamp_variate(float u) {
  constexpr float last = 1 - std::numeric_limits<float>::epsilon() / 2;
  return std::clamp(u, 0.0f, last);
}

/// A place on the unit disk; `r` may be negative, which means the opposite side.
struct Polar {
  double r, phi;
};

/// Shirley and Chiu 1997, with the sign of the radius kept (as in Cline's version) so that no case is split by it.
inline Polar concentric(double u, double v) {
  constexpr double quarter = std::numbers::pi / 4;
  const double a = 2 * u - 1;
  const double b = 2 * v - 1;
  if (a == 0 && b == 0) return {0, 0};
  if (std::abs(a) > std::abs(b)) return {a, quarter * (b / a)};
  return {b, 2 * quarter - quarter * (a / b)};
}

/// Polar coordinates whose area measure is dθ dt / 2 on the unit disk: 0 <= t <= 1 is the squared radius.
struct PolarArea {
  double theta, t;
};

inline PolarArea radial(double u, double v) { return {2 * std::numbers::pi * u, v}; }

inline PolarArea low_distortion(double u, double v) {
  const Polar p = concentric(u, v);
  return {p.r < 0 ? p.phi + std::numbers::pi : p.phi, p.r * p.r};
}

}  // namespace hatbox::reference
