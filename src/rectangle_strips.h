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

/// An angle in the first quadrant, from the legs of a right triangle: two numbers >= 0, not both 0.
template <class V>
struct RightAngle {
  V angle;
  SinCos<V> ratios;
  V hypotenuse;
};

template <class V>
struct RightAngles {
  RightAngle<V> first, second;
};

/// Two of them, which share a division.
template <class V>
HATBOX_INLINE inline RightAngles<V> right_angles(V opposite0, V adjacent0, V opposite1, V adjacent1) {
  struct Scaled {  // to a longer leg in [1, 2)
    V opposite, adjacent, hypotenuse, up;
    V sum;  // of adjacent and hypotenuse: the tangent of half the angle is opposite/sum
  };
  const auto scaled = [](V opposite, V adjacent) HATBOX_INLINE {
    const V longer = max(opposite, adjacent), down = inverse_power_of_two(longer);
    Scaled s = {opposite * down, adjacent * down, V(0), power_of_two(longer), V(0)};
    s.hypotenuse = sqrt(fma(s.opposite, s.opposite, s.adjacent * s.adjacent));
    s.sum = s.adjacent + s.hypotenuse;
    return s;
  };
  const auto angle = [](const Scaled& s, V inverse) HATBOX_INLINE {  // of hypotenuse · sum
    const V inverse_hypotenuse = s.sum * inverse;
    return RightAngle<V>{V(2) * atan_unit(s.opposite * (s.hypotenuse * inverse)),
                         {s.opposite * inverse_hypotenuse, s.adjacent * inverse_hypotenuse},
                         s.hypotenuse * s.up};
  };
  const Scaled s0 = scaled(opposite0, adjacent0), s1 = scaled(opposite1, adjacent1);
  const V product0 = s0.hypotenuse * s0.sum, product1 = s1.hypotenuse * s1.sum;
  const V both = V(1) / (product0 * product1);
  return {angle(s0, product1 * both), angle(s1, product0 * both)};
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

/// The part of the rectangle between two lines x = a and x = b, 0 <= a <= b.
template <class V>
struct Strip {
  StripEdge<V> near;
  V width;
  V w_near, W_far;
  RightAngle<V> half;  // of the area

  V area() const { return V(2) * half.angle; }
};

/// What a strip is made of. Its width is given, as far.x − near.x would lose it far away.
template <class V>
struct StripEnds {
  StripEdge<V> near, far;
  V width;
  V w_near;

  V sum0() const { return near.r0 + far.r0; }
  V sum1() const { return near.r1 + far.r1; }
  /// κ_b − κ_a, given 1/(sum0 sum1).
  V growth(V inverse) const {
    const V rho0 = near.rho0(), rho1 = far.rho1();
    return width * (rho0 + rho1 + (near.x + far.x) * (fma(rho0, sum0(), rho1 * sum1()) * inverse));
  }
};

/// Two strips, which share divisions.
template <class V>
HATBOX_INLINE inline void make_strips(const StripEnds<V>& first, const StripEnds<V>& second, V N, Strip<V>& first_strip,
                                      Strip<V>& second_strip) {
  const Inverses<V> inverse = inverses_of_products(first.sum0(), first.sum1(), second.sum0(), second.sum1());
  const V growth0 = first.growth(inverse.first), growth1 = second.growth(inverse.second);
  const V W0 = fma(first.w_near, N, growth0), W1 = fma(second.w_near, N, growth1);
  const RightAngles<V> half = right_angles(growth0, fma(first.w_near, W0, N), growth1, fma(second.w_near, W1, N));
  first_strip = {first.near, first.width, first.w_near, W0, half.first};
  second_strip = {second.near, second.width, second.w_near, W1, half.second};
}

template <class V>
struct RectangleStrips : RectangleSides<V> {
  HATBOX_INLINE explicit RectangleStrips(const RectangleSides<V>& sides);

  V area() const { return right.area() + left.area(); }  // seen from the height z

  StripEdge<V> edge_at(V x) const {
    const V x2 = x * x;
    return {x, sqrt(x2 + D0), sqrt(x2 + D1)};
  }

  V D0, D1, N;
  V kappa_f;       // κ at the foot
  V k_right;       // κ_f/κ where the right strip begins; where the left one does it is 1
  Strip<V> right;  // from max(x0, 0) to x1 …
  Strip<V> left;   // … and from the foot to −x0, nothing if x0 >= 0
};

// Either the right strip begins or the left one ends at |x0|, so its two roots do for both.
template <class V>
HATBOX_INLINE inline RectangleStrips<V>::RectangleStrips(const RectangleSides<V>& l) : RectangleSides<V>(l) {
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
  k_right = kappa_f / a.kappa();
  const V w_a = fma(V(2) * a.x, a.R() / (N + k_right * N), w_f);
  make_strips<V>({a, at_x1, select(straddling, l.x1, l.e_x), w_a}, {foot, at_x0, select(straddling, -l.x0, V(0)), w_f},
                 N, right, left);
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
