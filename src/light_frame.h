// What the constants of all flat lights are made of: vectors in double, and axes cut into what the kernels want.
#pragma once

#include <hatbox/lights.h>

#include <cmath>

namespace hatbox {

struct Double3 {
  double x, y, z;
};

inline Double3 in_double(const Vec3& v) { return {v.x, v.y, v.z}; }
inline double dot(const Double3& a, const Double3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Double3 scaled(double factor, const Double3& v) { return {factor * v.x, factor * v.y, factor * v.z}; }
/// Exact where v lies along an axis and has this length.
inline Double3 divided(const Double3& v, double length) { return {v.x / length, v.y / length, v.z / length}; }
/// A direction and a length.
struct Extent {
  Double3 unit;
  double length;
};
inline Extent extent_of(const Double3& v) {
  const double length = std::sqrt(dot(v, v));
  return {divided(v, length), length};
}
inline Double3 cross(const Double3& a, const Double3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Rounds to T and keeps what that leaves. Not inlined: where g++ 12 vectorizes several of these, the remainders it
/// computes are zero.
template <class T>
[[gnu::noinline]] void split(double value, T& high, T& low) {
  high = static_cast<T>(value);
  low = static_cast<T>(value - double{high});
}

/// An axis of the light, a unit vector, and in units of a length: rounded, and what the rounding left.
template <class T, template <class> class Constants>
void set_axis(Constants<T>& constants, int row, const Double3& unit, double inverse_length) {
  const double axis[3] = {unit.x, unit.y, unit.z};
  for (int i = 0; i < 3; ++i) {
    constants.axes[row][i] = static_cast<T>(axis[i]);
    split(axis[i] * inverse_length, constants.axes_hi[row][i], constants.axes_lo[row][i]);
  }
}

template <class T, template <class> class Constants>
void set_center(Constants<T>& constants, const Vec3& center) {
  constants.center[0] = center.x;
  constants.center[1] = center.y;
  constants.center[2] = center.z;
}

}  // namespace hatbox
