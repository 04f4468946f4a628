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

/// Max error: 1 ulp of 1, for |x| <= π/4. The fits are within 4e-9 (sin) and 1e-10 (cos), relative.
template <class V>
inline SinCos<V> sincos_eighth(V x) {
  if constexpr (std::is_same_v<V, double>) {
    return {std::sin(x), std::cos(x)};
  } else {
    const V y = x * x;
    const V s = fma(fma(constant<V>(-1.95172990e-4), y, constant<V>(8.33217815e-3)), y, constant<V>(-1.66666549e-1));
    const V c = fma(fma(constant<V>(2.44384516e-5), y, constant<V>(-1.38873675e-3)), y, constant<V>(4.16666469e-2));
    return {fma(s * y, x, x), fma(c * y, y, fma(constant<V>(-0.5), y, constant<V>(1)))};
  }
}

/// The same for |x| <= 0.2, by Taylor's series: max error 1 ulp of 1.
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

/// Sine and cosine of the sum of two angles given by theirs.
template <class V>
inline SinCos<V> rotate(const SinCos<V>& a, const SinCos<V>& b) {
  return {fma(a.sin, b.cos, a.cos * b.sin), fma(a.cos, b.cos, -(a.sin * b.sin))};
}

/// Max error: 2 ulp of π/4, for |x| <= 1. The fit is within 1.5e-8, relative.
template <class V>
inline V atan_unit(V x) {
  if constexpr (std::is_same_v<V, double>) {
    return std::atan(x);
  } else {
    const V y = x * x;
    constexpr double fit[] = {2.97459611e-3, -1.65812058e-2, 4.35535731e-2,  -7.58058084e-2,
                              1.06789415e-1, -1.42142094e-1, 1.99941372e-1, -3.33331670e-1};
    V p = constant<V>(fit[0]);
    for (int i = 1; i < 8; ++i) p = fma(p, y, constant<V>(fit[i]));
    return fma(p * y, x, x);
  }
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
