// The sine series of eta_series.h where the rim is nearly flat, k' >= 1/2, as a fit: no root a midpoint, no inversion.
//
// With the mean height C = (cos α + cos β)/2 and ρ = (1 − k')/(1 + k') the rim's height is h(η) = C |1 − ρ e^{2iη}|,
// and only f = C/(1 + C) counts of C. Taylor's series of dη/dθ in ρ then has polynomials of f: the coefficient of x^i
// in P is f ρ^(i + 1) times an even series in ρ, whose first terms suffice, made to fit all ρ up to 1/3 (eta_fit.py).
//
// Largest error of the slope dη/dθ: 8e-6 at k' = 0.5, 1e-6 from k' = 0.78 up.
#pragma once

#include "spherical_ellipse.h"

namespace hatbox::HATBOX_ISA {
namespace {

/// Lowest power first.
template <class V, class... Rest>
HATBOX_INLINE inline V polynomial(V x, double first, Rest... rest) {
  if constexpr (sizeof...(Rest) == 0) {
    return constant<V>(first);
  } else {
    return fma(polynomial(x, rest...), x, constant<V>(first));
  }
}

template <class V>
HATBOX_INLINE inline void fitted_series(const SphericalEllipse<V>& cone, V (&p)[6]) {
  const V k = sqrt(cone.k2);
  const V one_plus_k = V(1) + k;
  const V C = V(0.5) * cone.cos_beta * one_plus_k;
  const V one_plus_C = V(1) + C;
  const V shared = V(1) / (one_plus_k * one_plus_C);
  // What cancels in 1 − k hardly counts; powers of what is left of it far from the light would underflow, which is
  // slow.
  const V rho = max((V(1) - k) * (one_plus_C * shared), constant<V>(0x1p-21));
  const V f = C * (one_plus_k * shared);

  const V rho2 = rho * rho;
  const V p0 = f * rho, p1 = p0 * rho, p2 = p1 * rho, p3 = p1 * rho2, p4 = p2 * rho2;
  p[0] = p0 * fma(rho2,
                  fma(rho2, polynomial(f, 0.0399383718, -0.00851969049),
                      polynomial(f, 0.161342946, -0.143243988, -0.191778504)),
                  constant<V>(-0.999994746));
  p[1] = p1 * fma(rho2, polynomial(f, 0.145459616, -0.53790145, 0.452266332), polynomial(f, -0.250062944, 0.500186667));
  p[2] = p2 * fma(rho2, constant<V>(0.0210621871), polynomial(f, -0.156964044, 0.381153338, -0.307611039));
  p[3] = p3 * polynomial(f, -0.144657893, 0.369467374, -0.249413841);
  p[4] = p4 * polynomial(f, -0.102716051, 0.154671746);
  p[5] = V(0);
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
