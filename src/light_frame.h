// What the constants of all flat lights are made of: vectors in double, and axes cut into what the kernels want.
#pragma once

#include <hatbox/lights.h>

#include <bit>
#include <cmath>
#include <cstdint>

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

/// The power of two at or next below a length > 0 that is a normal double, as those made of floats are: its exponent.
inline double power_of_two_below(double length) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(length) & 0x7ff0'0000'0000'0000u);
}

template <class T>
void set_vector(T (&to)[3], const Double3& v) {
  to[0] = static_cast<T>(v.x);
  to[1] = static_cast<T>(v.y);
  to[2] = static_cast<T>(v.z);
}

/// Rounded, and what the rounding left.
template <class T>
void set_split(T (&high)[3], T (&low)[3], const Double3& v) {
  split(v.x, high[0], low[0]);
  split(v.y, high[1], low[1]);
  split(v.z, high[2], low[2]);
}

}  // namespace hatbox
