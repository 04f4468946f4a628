// From the unit square to the polar coordinates of the maps, and back: the concentric map and the plain polar one.
// An angle is kept as its sine and cosine, so that no map needs an arc tangent on the way forward.
#pragma once

#include "trig.h"

namespace hatbox::HATBOX_ISA {
namespace {

/// A point of the unit disk: signed radius r and angle θ; (−r, θ) means (r, θ + π).
template <class V>
struct Polar {
  V radius;
  SinCos<V> angle;
};

template <class V>
struct Square {
  V u, v;
};

/// Into [0, 1): what lies outside goes to the nearest float inside. NaN becomes 0; callers look for it themselves.
template <class V>
inline V clamp_variate(V x) {
  return max(min(constant<V>(last_below_one<V>), x), V(0));
}

/// Concentric map (Shirley and Chiu 1997), with the signed radius of Cline's branch-free form.
template <class V>
inline Polar<V> concentric(V u, V v) {
  const V a = fma(V(2), u, V(-1));
  const V b = fma(V(2), v, V(-1));
  const Mask<V> flat = abs(a) > abs(b);  // the sectors around the u axis; the others are measured from the v axis
  const V r = select(flat, a, b);
  const V ratio = select(flat, b, a) / select(r == V(0), V(1), r);
  const SinCos<V> phi = sincos_eighth(constant<V>(pi / 4) * ratio);
  return {r, {select(flat, phi.sin, phi.cos), select(flat, phi.cos, phi.sin)}};
}

/// The inverse of `concentric`, for radius >= 0. Exact to a few ulp of 1.
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

/// θ = 2πu, radius √v.
template <class V>
inline Polar<V> polar(V u, V v) {
  const Mask<V> upper = u >= V(0.5);
  const V half_turn = select(upper, u - V(0.5), u);  // θ less the half turn that the sign of the radius makes up for
  const Mask<V> middle = (half_turn >= V(0.125)) && (half_turn < V(0.375));
  const V offset = select(middle, V(0.25), select(half_turn < V(0.125), V(0), V(0.5)));
  const SinCos<V> phi = sincos_eighth(constant<V>(2 * pi) * (half_turn - offset));
  const Mask<V> past = half_turn >= V(0.375);
  const V sin = select(middle, phi.cos, select(past, -phi.sin, phi.sin));
  const V cos = select(middle, -phi.sin, select(past, -phi.cos, phi.cos));
  const V r = sqrt(v);
  return {select(upper, -r, r), {sin, cos}};
}

/// The inverse of `polar`, for radius >= 0.
template <class V>
inline Square<V> polar_inverse(const Polar<V>& p) {
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
