// The solid angle of a rectangle, in the form that its map inverts: the two strips x < 0 and x > 0 of it, each in
// closed form and without cancellation, right to a few ulp from the smallest float to 2π.
//
// UFK13 sums the four angles of the spherical rectangle, which is all cancellation where it is small. But the strip
// from x to infinity is a spherical triangle with its apex at infinity, and half of its area has the tangent N/W, with
//   N = z·e_y,  W = κ + c,  κ = ρ0 ρ1,  ρ_j = x + r_j,  r_j = √(x² + D_j),  D_j = y_j² + z²,  c = y0 y1 + z².
// So half of a strip's area A from a to b is the difference of two arc tangents,
//   tan(A/2) = ΔW/(w_a W_b + N),  w = W/N,  ΔW = W_b − W_a = κ_b − κ_a,
// and all differences factor, because with κ_f = √(D0 D1), which is κ at the foot x = 0, and R = r0 + r1
//   κ − κ_f²/κ = 2xR,  κ + κ_f²/κ + D0 + D1 = R²,  (κ_f + c)(κ_f − c) = N².
#pragma once

#include "rectangle_local.h"

namespace hatbox::HATBOX_ISA {
namespace {

/// An angle in the first quadrant, from its tangent opposite/adjacent: any two numbers >= 0, not both 0.
template <class V>
struct RightAngle {
  V angle;
  SinCos<V> ratios;
  V hypotenuse;
};

// With t = tan of half the angle, which is at most one: the quotient that is at most one is squared.
template <class V>
HATBOX_INLINE inline RightAngle<V> right_angle(V opposite, V adjacent) {
  const Mask<V> steep = opposite > adjacent;
  const V longer = select(steep, opposite, adjacent);
  const V quotient = select(steep, adjacent, opposite) / longer;
  const V stretch = sqrt(fma(quotient, quotient, V(1)));
  const V inverse = V(1) / stretch;
  const V small = quotient * inverse;
  const V half_tangent = select(steep, V(1), quotient) / (select(steep, quotient, V(1)) + stretch);
  return {
      V(2) * atan_unit(half_tangent), {select(steep, inverse, small), select(steep, small, inverse)}, longer * stretch};
}

/// What there is to know at one x >= 0.
template <class V>
struct StripEdge {
  V x, r0, r1;

  V rho0() const { return x + r0; }
  V rho1() const { return x + r1; }
  V kappa() const { return rho0() * rho1(); }
  V R() const { return r0 + r1; }
};

/// κ_b − κ_a. The width is given, as b.x − a.x would lose it far away.
template <class V>
HATBOX_INLINE inline V kappa_growth(const StripEdge<V>& a, const StripEdge<V>& b, V width) {
  const V rho0 = a.rho0(), rho1 = b.rho1();
  const V sum0 = a.r0 + b.r0, sum1 = a.r1 + b.r1;
  const V steepness = (a.x + b.x) * fma(rho0, sum0, rho1 * sum1) / (sum0 * sum1);
  return width * (rho0 + rho1 + steepness);
}

/// The part of the rectangle between two lines x = a and x = b, 0 <= a <= b.
template <class V>
struct Strip {
  StripEdge<V> near;
  V width;
  V w_near, W_far;
  RightAngle<V> half;  // of the area

  V area() const { return V(2) * half.angle; }
};

template <class V>
HATBOX_INLINE inline Strip<V> strip_between(const StripEdge<V>& a, const StripEdge<V>& b, V width, V w_a, V N) {
  const V growth = kappa_growth(a, b, width);
  const V W_b = fma(w_a, N, growth);
  return {a, width, w_a, W_b, right_angle(growth, fma(w_a, W_b, N))};
}

template <class V>
struct RectangleStrips : RectangleLocal<V> {
  HATBOX_INLINE RectangleStrips(const RectangleLight<V>& rectangle, V px, V py, V pz);

  /// Whether the foot of the shading point lies off the light.
  Mask<V> beside() const { return max(this->x0, this->y0) > V(0); }

  V solid_angle() const { return (right.area() + left.area()) * shrinking(); }

  /// How much smaller the solid angle is than that seen from the height z.
  V shrinking() const {
    const V share = min(abs(this->height) * constant<V>(1 / least_height), V(1));
    return select(beside(), share, V(1));
  }

  StripEdge<V> edge_at(V x) const {
    const V x2 = x * x;
    return {x, sqrt(x2 + D0), sqrt(x2 + D1)};
  }

  V D0, D1, N;
  V kappa_f;       // κ at the foot
  Strip<V> right;  // from max(x0, 0) to x1 …
  Strip<V> left;   // … and from the foot to −x0, nothing if x0 >= 0
};

// Either the right strip begins or the left one ends at |x0|, so its two roots do for both.
template <class V>
HATBOX_INLINE inline RectangleStrips<V>::RectangleStrips(const RectangleLight<V>& rectangle, V px, V py, V pz)
    : RectangleLocal<V>(rectangle, px, py, pz) {
  const RectangleLocal<V>& l = *this;
  const V z2 = l.z * l.z;
  D0 = fma(l.y0, l.y0, z2);
  D1 = fma(l.y1, l.y1, z2);
  N = l.z * l.e_y;
  const V c = fma(l.y0, l.y1, z2);
  const StripEdge<V> foot = {V(0), sqrt(D0), sqrt(D1)};
  kappa_f = foot.r0 * foot.r1;
  const Mask<V> acute = c >= V(0);
  const V w_f = select(acute, kappa_f + c, N) / select(acute, N, kappa_f - c);

  const Mask<V> straddling = l.x0 < V(0);
  const StripEdge<V> at_x0 = edge_at(abs(l.x0)), at_x1 = edge_at(l.x1);
  const StripEdge<V> a = {select(straddling, V(0), l.x0), select(straddling, foot.r0, at_x0.r0),
                          select(straddling, foot.r1, at_x0.r1)};
  const V kappa_a = a.kappa();
  const V w_a = fma(V(2) * a.x, a.R() * kappa_a / ((kappa_a + kappa_f) * N), w_f);
  right = strip_between(a, at_x1, select(straddling, l.x1, l.e_x), w_a, N);
  left = strip_between(foot, at_x0, select(straddling, -l.x0, V(0)), w_f, N);
}

template <class V>
inline V solid_angle_of(const RectangleStrips<V>& strips) {
  return strips.solid_angle();
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
