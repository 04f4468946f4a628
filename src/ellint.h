// Legendre's incomplete elliptic integrals F(φ|m), E(φ|m) and Π(n;φ|m) by Carlson's, every form chosen so that no two
// terms cancel; m is the parameter, k². For |φ| > π/2 the complete integral is added as often as φ passes a multiple of
// π.
//
// Sources: DLMF 19.25.5, 9-11 and 14; for n < 0 DLMF 19.21.12 with cos²φ in the place of x.
#pragma once

#include "carlson_domain.h"
#include "trig.h"

namespace hatbox::HATBOX_ISA {
namespace {

/// φ = π·half_turns + the angle in [−π/2, π/2] of this sine and cosine, both right to a few ulp.
template <class V>
struct Amplitude {
  V sin, cos, half_turns;
  Mask<V> quarter;  // φ is the float nearest to ±π/2, which stands for ±π/2 itself

  HATBOX_INLINE Mask<V> is_reduced() const { return half_turns == V(0); }
};

inline constexpr double largest_amplitude = 0x1p20;  // a float knows its angle to 1/16 there

/// x to the nearest whole number, |x| <= 2^21: what does not fit behind the point of 1.5·2^23 is rounded away.
template <class V>
HATBOX_INLINE inline V round_to_whole(V x) {
  const V whole = constant<V>(1.5 / std::numeric_limits<Scalar<V>>::epsilon());
  return (x + whole) - whole;
}

/// φ − q·π/2, π/2 in three floats (Cody and Waite 1980): the first difference is exact, so the rest is right to an ulp
/// even next to a multiple of π/2.
template <class V>
HATBOX_INLINE inline V off_quarter_turns(V phi, V q) {
  constexpr double high = 0x1.921fb6p+0, middle = -0x1.777a5cp-25, low = -0x1.ee59dap-50;
  return fma(-q, constant<V>(low), fma(-q, constant<V>(middle), fma(-q, constant<V>(high), phi)));
}

/// Of |x| <= 0.8: minimax fits made for this file, within 1e-8 (sin) and 1e-8 (cos), relative.
template <class V>
HATBOX_INLINE inline SinCos<V> sincos_eighth_turn(V x) {
  if constexpr (std::is_same_v<V, double>) {
    return {std::sin(x), std::cos(x)};
  } else {
    const V y = x * x;
    const V s =
        fma(fma(constant<V>(-0.000195867160159), y, constant<V>(0.00833274199348)), y, constant<V>(-0.166666646213));
    const V c =
        fma(fma(constant<V>(2.45469633651e-5), y, constant<V>(-0.00138882979772)), y, constant<V>(0.041666664628));
    return {fma(s * y, x, x), fma(c * y, y, fma(V(-0.5), y, V(1)))};
  }
}

template <class V>
HATBOX_INLINE inline Amplitude<V> amplitude(V phi) {
  const Mask<V> known = abs(phi) <= constant<V>(largest_amplitude);
  const V angle = select(known, phi, V(0));
  const V q = round_to_whole(angle * constant<V>(2 / pi));
  const Mask<V> quarter = abs(angle) == constant<V>(static_cast<float>(pi / 2));
  // Not +0 or −0 alike: its sign tells on which side of the quarter turn φ lies.
  const V rest = select(quarter, copysign(V(0), -angle), off_quarter_turns(angle, q));
  const SinCos<V> small = sincos_eighth_turn(rest);
  const V half = V(0.5) * q;
  const Mask<V> even = round_to_whole(half) == half;
  const V nan_if_unknown = select(known, V(0), not_a_number<V>());
  return {select(even, small.sin, -copysign(small.cos, rest)) + nan_if_unknown, select(even, small.cos, abs(small.sin)),
          half + select(even, V(0), copysign(V(0.5), rest)), quarter};
}

/// incomplete + 2·half_turns·complete, where the latter is asked for only if a lane needs it.
template <class V, class Complete>
HATBOX_INLINE inline V unfolded(const Amplitude<V>& phi, V incomplete, const Complete& complete) {
  if (!any(!phi.is_reduced())) return incomplete;
  return select(phi.is_reduced(), incomplete, fma(V(2) * phi.half_turns, complete(), incomplete));
}

/// The pole of F and Π at φ = ±π/2, approached from within.
template <class V>
HATBOX_INLINE inline V with_pole(Mask<V> at_pole, V sin, V integral) {
  return select(at_pole, copysign(constant<V>(infinity<V>), sin), integral);
}

/// 1 − m sin²φ
template <class V>
HATBOX_INLINE inline V delta_squared(V sin2, V cos2, V m) {
  return fma(V(1) - m, sin2, cos2);
}

template <class V>
HATBOX_INLINE inline V ellint_f(V angle, V m) {
  const Amplitude<V> phi = amplitude(angle);
  const V cos2 = phi.cos * phi.cos, sin2 = phi.sin * phi.sin;
  const V within = phi.sin * carlson_rf(cos2, delta_squared(sin2, cos2, m), V(1));
  const V all = unfolded(phi, within, [&]() HATBOX_INLINE { return carlson_rf(V(0), V(1) - m, V(1)); });
  return with_pole(phi.quarter && (m == V(1)), phi.sin, all);
}

/// E(φ|m)/sin φ for |φ| <= π/2. For m < 0, up to 1 and above, DLMF 19.25.9, 10 and 11: positive terms only.
template <class V>
HATBOX_INLINE inline V second_kind(V sin, V cos, V m) {
  const V cos2 = cos * cos, sin2 = sin * sin;
  const V delta2 = delta_squared(sin2, cos2, m);
  const Mask<V> below = m<V(0), above = m> V(1);
  const FirstAndThird<V> r = carlson_rf_rd<Wanted::both>(select(above, delta2, cos2), select(below, delta2, V(1)),
                                                         select(below, V(1), select(above, cos2, delta2)));
  const V third = constant<V>(1.0 / 3) * sin2 * r.rj;
  const V n1 = V(1) - m;
  const V ratio = sqrt(select(above, delta2, cos2) / select(above, cos2, delta2));
  const V inside = fma(n1, fma(m, third, r.rf), m * ratio);
  const V result = select(below, fma(-m, third, r.rf), select(above, fma(-n1, third, ratio), inside));
  return select(m == V(1), V(1) + V(0) * sin, result);
}

template <class V>
HATBOX_INLINE inline V ellint_e(V angle, V m) {
  const Amplitude<V> phi = amplitude(angle);
  const V within = phi.sin * second_kind(phi.sin, phi.cos, m);
  return unfolded(phi, within, [&]() HATBOX_INLINE { return second_kind(V(1), V(0), m); });
}

/// Π(n;φ|m)/sin φ for |φ| <= π/2. For n < 0, with N = 1 − n and q = cos²φ + sin²φ (1 − m)/N,
///   R_F/N − (n/N) [cos φ R_C(Δ², q (cos²φ + N sin²φ)) + sin²φ (1 − m)/(3N) R_J(cos²φ, Δ², 1, q)]
template <class V>
HATBOX_INLINE inline V third_kind(V n, V sin, V cos, V m) {
  const V cos2 = cos * cos, sin2 = sin * sin;
  const V delta2 = delta_squared(sin2, cos2, m);
  const Mask<V> negative = n < V(0);
  const V N = V(1) - n;
  const V inverse = V(1) / select(negative, N, V(1));
  const V q_less = sin2 * ((V(1) - m) * inverse);
  const V pole = fma(N, sin2, cos2);  // 1 − n sin²φ
  const V q = cos2 + q_less;
  const FirstAndThird<V> r = carlson_rf_rj(cos2, delta2, V(1), select(negative, q, pole));
  const V third = constant<V>(1.0 / 3) * r.rj;
  const V plain = fma(n * sin2, third, r.rf);
  if (!any(negative)) return plain;
  const V rest = fma(q_less, third, cos * carlson_rc(delta2, select(negative, q * pole, V(1))));
  return select(negative, inverse * fma(-n, rest, r.rf), plain);
}

template <class V>
HATBOX_INLINE inline V ellint_pi(V n, V angle, V m) {
  const Amplitude<V> phi = amplitude(angle);
  const V within = phi.sin * third_kind(n, phi.sin, phi.cos, m);
  const V all = unfolded(phi, within, [&]() HATBOX_INLINE { return third_kind(n, V(1), V(0), m); });
  const Mask<V> at_pole = (m == V(1) && n <= V(1)) || (n == V(1) && m <= V(1));
  return with_pole(phi.quarter && at_pole, phi.sin, all);
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
