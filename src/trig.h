// Sine, cosine and arc tangent on the ranges the maps need, where no reduction is needed. The polynomials are minimax
// fits made for this file (Remez exchange, relative error); double, which only tests use, takes the standard library's.
#pragma once

#include "fma.h"

namespace hatbox::HATBOX_ISA {
namespace {

inline constexpr double pi = 3.14159265358979323846;

template <class V>
struct SinCos {
  V sin, cos;
};

/// Of π/4·x. Max error: 1 ulp of 1, for |x| <= 1. The fits are within 4e-9 (sin) and 1e-10 (cos), relative.
template <class V>
inline SinCos<V> sincos_octant(V x) {
  if constexpr (std::is_same_v<V, double>) {
    return {std::sin(pi / 4 * x), std::cos(pi / 4 * x)};
  } else {
    const V y = x * x;
    const V s = fma(fma(constant<V>(-3.597898312126e-05), y, constant<V>(2.490049345575e-03)), y,
                    constant<V>(-8.074545539366e-02));
    const V c = fma(fma(fma(constant<V>(3.538284392469e-06), y, constant<V>(-3.259561781469e-04)), y,
                        constant<V>(1.585433670973e-02)),
                    y, constant<V>(-3.084251375340e-01));
    return {x * fma(s, y, constant<V>(pi / 4)), fma(c, y, V(1))};
  }
}

/// Of π/4·octants, for 0 <= octants <= 2.
template <class V>
inline SinCos<V> sincos_quadrant(V octants) {
  const Mask<V> low = octants <= V(1);
  const SinCos<V> s = sincos_octant(select(low, octants, V(2) - octants));
  return {select(low, s.sin, s.cos), select(low, s.cos, s.sin)};
}

/// Of x itself, for |x| <= 0.2, by Taylor's series: max error 1 ulp of 1.
template <class V>
inline SinCos<V> sincos_small(V x) {
  if constexpr (std::is_same_v<V, double>) {
    return {std::sin(x), std::cos(x)};
  } else {
    const V y = x * x;
    const V s = fma(constant<V>(1.0 / 120), y, constant<V>(-1.0 / 6));
    const V c = fma(fma(constant<V>(-1.0 / 720), y, constant<V>(1.0 / 24)), y, constant<V>(-0.5));
    return {fma(s * y, x, x), fma(c, y, constant<V>(1))};
  }
}

/// The sine alone. Max error: 2 ulp, relative, for 0 <= x <= π/2, whose nearest float may be exceeded by a few ulp. The
/// fit is within 1.1e-8, relative.
template <class V>
inline V sin_of_acute(V x) {
  if constexpr (std::is_same_v<V, double>) {
    return std::sin(x);
  } else {
    const V y = x * x;
    const V s = fma(fma(fma(constant<V>(2.601872388572e-06), y, constant<V>(-1.980740505946e-04)), y,
                        constant<V>(8.333024950667e-03)),
                    y, constant<V>(-1.666665667580e-01));
    return fma(s * y, x, x);
  }
}

/// Sine and cosine of the sum of two angles given by theirs.
template <class V>
inline SinCos<V> rotate(const SinCos<V>& a, const SinCos<V>& b) {
  return {fma(a.sin, b.cos, a.cos * b.sin), fma(a.cos, b.cos, -(a.sin * b.sin))};
}

/// Sine and cosine of twice an angle.
template <class V>
inline SinCos<V> doubled(const SinCos<V>& a) {
  const V sin2 = V(2) * a.sin;
  return {sin2 * a.cos, fma(-sin2, a.sin, V(1))};
}

/// Max error: 2 ulp of π/4, for |x| <= 1. The fit is within 1.5e-8, relative.
template <class V>
inline V atan_unit(V x) {
  if constexpr (std::is_same_v<V, double>) {
    return std::atan(x);
  } else {
    const V y = x * x;
    constexpr double fit[] = {2.97459611e-3, -1.65812058e-2, 4.35535731e-2, -7.58058084e-2,
                              1.06789415e-1, -1.42142094e-1, 1.99941372e-1, -3.33331670e-1};
    V p = constant<V>(fit[0]);
    for (int i = 1; i < 8; ++i) p = fma(p, y, constant<V>(fit[i]));
    return fma(p * y, x, x);
  }
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
