// From the unit square to the polar coordinates of the maps, and back: the concentric map and the plain polar one.
// An angle is kept as its sine and cosine, so that no map needs an arc tangent on the way forward.
#pragma once

#include "trig.h"

namespace hatbox::HATBOX_ISA {
namespace {

/// A point of the unit disk, 0 <= radius < 1.
template <class V>
struct Polar {
  V radius;
  SinCos<V> angle;
};

template <class V>
struct Square {
  V u, v;
};

/// A variate and what it lacks to 1.
template <class V>
struct Shares {
  V share, rest;
};

/// Into [0, 1): what lies outside goes to the nearest float inside. NaN becomes 0; callers look for it themselves.
template <class V>
inline V clamp_variate(V x) {
  return max(min(constant<V>(last_below_one<V>), x), V(0));
}

template <class V>
inline Shares<V> shares_of(V variate) {
  const V share = clamp_variate(variate);
  return {share, V(1) - share};
}

/// Concentric map (Shirley and Chiu 1997), the eight sectors folded into one. Clamps like clamp_variate; the four edges
/// of the square are alike, an ulp inside the rim.
template <class V>
inline Polar<V> concentric(V u, V v) {
  const V a = fma(V(2), u, V(-1));
  const V b = fma(V(2), v, V(-1));
  const V abs_a = abs(a), abs_b = abs(b);
  const V edge = constant<V>(2 * last_below_one<V> - 1);
  const V major = min(max(abs_a, abs_b), edge);
  const V minor = min(min(abs_a, abs_b), edge);
  // The sum is major itself, but for the centre, where it keeps the quotient at 0.
  const SinCos<V> phi = sincos_octant(minor / (major + constant<V>(smallest_normal<V>)));
  const Mask<V> flat = abs_a > abs_b;  // nearer the u axis than the v axis
  return {major, {copysign(select(flat, phi.sin, phi.cos), b), copysign(select(flat, phi.cos, phi.sin), a)}};
}

/// The inverse of `concentric`, exact to a few ulp of 1.
template <class V>
inline Square<V> concentric_inverse(const Polar<V>& p) {
  const Mask<V> flat = abs(p.angle.cos) > abs(p.angle.sin);
  const V major = select(flat, p.angle.cos, p.angle.sin);
  const V minor = select(flat, p.angle.sin, p.angle.cos);
  const V r = select(major < V(0), -p.radius, p.radius);
  const V other = r * (atan_unit(minor / major) * constant<V>(4 / pi));
  const V a = select(flat, r, other);
  const V b = select(flat, other, r);
  return {fma(V(0.5), a, V(0.5)), fma(V(0.5), b, V(0.5))};
}

/// θ = 2πu, radius √v. (`polar` alone is xsimd's too from 9.0 on.)
template <class V>
inline Polar<V> plain_polar(V u, V v) {
  const V turn = clamp_variate(u);
  const Mask<V> upper = turn >= V(0.5);
  const V half_turn = select(upper, turn - V(0.5), turn);
  const Mask<V> middle = (half_turn >= V(0.125)) && (half_turn < V(0.375));
  const Mask<V> past = half_turn >= V(0.375);
  const V offset = select(middle, V(0.25), select(past, V(0.5), V(0)));
  const SinCos<V> phi = sincos_octant(V(8) * (half_turn - offset));
  const V sin = select(middle, phi.cos, select(past, -phi.sin, phi.sin));
  const V cos = select(middle, -phi.sin, select(past, -phi.cos, phi.cos));
  return {sqrt(clamp_variate(v)), {select(upper, -sin, sin), select(upper, -cos, cos)}};
}

/// The inverse of `plain_polar`.
template <class V>
inline Square<V> plain_polar_inverse(const Polar<V>& p) {
  const Mask<V> flat = abs(p.angle.cos) > abs(p.angle.sin);
  const V major = select(flat, p.angle.cos, p.angle.sin);
  const V minor = select(flat, p.angle.sin, p.angle.cos);
  const V turn = atan_unit(minor / major) * constant<V>(0.5 / pi);  // from the nearest axis, in turns
  const V from_u = select(p.angle.cos < V(0), turn + V(0.5), select(turn < V(0), turn + V(1), turn));
  const V from_v = select(p.angle.sin < V(0), V(0.75), V(0.25)) - turn;
  return {select(flat, from_u, from_v), p.radius * p.radius};
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
