// RectangleMap::spherical: uniform in solid angle. u moves a line x = const over the rectangle as seen, v a point along
// it (UFK13 §4.3 and 4.4), both by the closed forms of rectangle_strips.h instead of the paper's, which cancel.
//
// A share of a strip's area is a share of its angle, and with half of the area before the line, θ_u, and behind it,
// θ_f,
//   Δκ = κ − κ_a = G sin θ_u/(cos θ_f + w_b sin θ_f),  G² = ΔW² + (w_a W_b + N)²,
// from which κ and R give x. Along the line h = y/r is uniform (eq. 9), and 1 − h and 1 + h are kept beside h. The
// place is an offset from the nearer side, or from the foot if that lies on the light, up to its end: a place in [0, 1]
// alone would lose the direction to what hugs the light, a coordinate alone the place on what is far.
#pragma once

#include "rectangle_strips.h"

namespace hatbox::HATBOX_ISA {
namespace {

/// A variate and what it lacks to 1.
template <class V>
struct Shares {
  V share, rest;
};

template <class V>
HATBOX_INLINE inline Shares<V> shares_of(V variate, Mask<V> flip) {
  const V share = clamp_variate(variate), rest = V(1) - share;
  return {select(flip, rest, share), select(flip, share, rest)};
}

/// The line x = const, across which y runs: y0 and y1 as seen along it.
template <class V>
struct RectangleLine {
  struct End {
    V r;  // distance from the shading point
    V inverse_r;
    V h;              // y/r
    V less_than_one;  // 1 − |h|
  };

  HATBOX_INLINE RectangleLine(const RectangleLocal<V>& local, V x) : d2(fma(x, x, local.z * local.z)) {
    const V r0 = sqrt(fma(local.y0, local.y0, d2)), r1 = sqrt(fma(local.y1, local.y1, d2));
    const V sum0 = r0 + abs(local.y0), sum1 = r1 + abs(local.y1);
    const Inverses<V> inverse = inverses_of_products(r0, sum0, r1, sum1);
    const auto end = [&](V y, V r, V sum, V inverse_product) HATBOX_INLINE {
      const V inverse_r = sum * inverse_product;
      return End{r, inverse_r, y * inverse_r, d2 * inverse_product};
    };
    low = end(local.y0, r0, sum0, inverse.first);
    high = end(local.y1, r1, sum1, inverse.second);
  }

  V d2;  // squared distance of the line
  End low, high;
};

template <class V>
class SphericalRectangle {
 public:
  HATBOX_INLINE SphericalRectangle(const RectangleLight<V>& light, V x, V y, V z);

  HATBOX_INLINE LightSample<V> sample(V u, V v) const;
  V pdf_of_place(const Place<V>& place) const { return select(on_unit_square(place) && valid_, density_, V(0)); }
  V pdf_of_direction(const V (&direction)[3]) const {
    return select(strips_.hit(direction).inside && valid_, density_, V(0));
  }
  Square<V> invert(const V (&direction)[3]) const;

 private:
  /// A coordinate, and its offset from the rectangle's side x0 or y0.
  struct Coordinate {
    V value, offset;
  };
  struct OnLine {
    Coordinate y;
    V r, inverse_r;
  };
  HATBOX_INLINE Coordinate x_of(const Shares<V>& u) const;
  HATBOX_INLINE OnLine y_of(const Shares<V>& v, const RectangleLine<V>& line) const;
  V u_of(V x) const;
  V v_of(V x, V y) const;

  RectangleStrips<V> strips_;
  V omega_;    // seen from the height z
  V density_;  // 1/Ω
  Mask<V> valid_;
};

template <class V>
HATBOX_INLINE inline SphericalRectangle<V>::SphericalRectangle(const RectangleLight<V>& light, V x, V y, V z)
    : strips_(light, x, y, z) {
  omega_ = strips_.right.area() + strips_.left.area();
  const V solid_angle = omega_ * strips_.shrinking();
  density_ = V(1) / solid_angle;
  valid_ = honest(honest(strips_.valid, solid_angle), density_);
}

template <class V>
HATBOX_INLINE inline LightSample<V> SphericalRectangle<V>::sample(V u, V v) const {
  const Coordinate x = x_of(shares_of(u, strips_.flip_x));
  const OnLine on_line = y_of(shares_of(v, strips_.flip_y), RectangleLine<V>(strips_, x.value));
  const V inverse_r = on_line.inverse_r;
  const V height = select(strips_.beside(), strips_.height, copysign(strips_.z, strips_.height));
  const V along[3] = {select(strips_.flip_x, -x.value, x.value) * inverse_r,
                      select(strips_.flip_y, -on_line.y.value, on_line.y.value) * inverse_r, height * inverse_r};
  const RectangleLight<V>& light = strips_.light;
  LightSample<V> out;
  for (int i = 0; i < 3; ++i) {
    out.direction[i] =
        fma(V(light.axes_hi[0][i]), along[0], fma(V(light.axes_hi[1][i]), along[1], V(light.axes_hi[2][i]) * along[2]));
  }
  out.distance = on_line.r * strips_.scale;
  out.pdf = density_;
  out.cosine = -along[2];
  out.place = strips_.place_at(x.offset, on_line.y.offset);
  out.valid = valid_ && is_finite(u + v) && is_finite(out.distance + inverse_r);
  return out;
}

template <class V>
HATBOX_INLINE inline auto SphericalRectangle<V>::x_of(const Shares<V>& u) const -> Coordinate {
  const V before = u.share * omega_, left_area = strips_.left.area();
  const Mask<V> on_left = before < left_area;
  const auto pick = [&](V left, V right) { return select(on_left, left, right); };
  const Strip<V>&left = strips_.left, &right = strips_.right;
  const StripEdge<V> a = {pick(left.near.x, right.near.x), pick(left.near.r0, right.near.r0),
                          pick(left.near.r1, right.near.r1)};
  const SinCos<V> whole = {pick(left.half.ratios.sin, right.half.ratios.sin),
                           pick(left.half.ratios.cos, right.half.ratios.cos)};
  const V W_b = pick(left.W_far, right.W_far);
  const V G = pick(left.half.hypotenuse, right.half.hypotenuse);

  // Of the two angles the smaller is below an eighth of a turn; the other is what is left of the whole.
  const V theta_u = V(0.5) * abs(before - left_area), theta_f = V(0.5) * pick(before, u.rest * omega_);
  const Mask<V> u_smaller = theta_u < theta_f;
  const SinCos<V> small = sincos_octant(select(u_smaller, theta_u, theta_f) * constant<V>(4 / pi));
  const SinCos<V> large = rotate(whole, {-small.sin, small.cos});
  const SinCos<V> f = {select(u_smaller, large.sin, small.sin), select(u_smaller, large.cos, small.cos)};
  const V sin_u = select(u_smaller, small.sin, large.sin);

  const V kappa_a = a.kappa(), R_a = a.R(), N = strips_.N;
  const V growth = G * N * sin_u / fma(W_b, f.sin, N * f.cos);
  const V kappa = kappa_a + growth;
  const V g = strips_.kappa_f / kappa;
  const V R = sqrt(fma(strips_.kappa_f, g, kappa) + (strips_.D0 + strips_.D1));
  const V k = pick(V(1), strips_.k_right) * g, sum = R + R_a;
  const V numerator = fma(V(1) + k, sum, V(-2) * a.x * (V(1) - k));
  const V step = max(min(growth * numerator / (V(2) * R * sum), pick(left.width, right.width)), V(0));
  const V from_side = max(-strips_.x0, V(0));  // of the foot
  return {pick(-step, a.x + step), pick(from_side - step, from_side + step)};
}

template <class V>
HATBOX_INLINE inline auto SphericalRectangle<V>::y_of(const Shares<V>& v, const RectangleLine<V>& line) const
    -> OnLine {
  const auto &low = line.low, &high = line.high;
  const V y0 = strips_.y0, y1 = strips_.y1, e_y = strips_.e_y;
  const Mask<V> straddling = y0 < V(0);
  const V more = V(1) + abs(low.h);
  const V minus = fma(v.rest, select(straddling, more, low.less_than_one), v.share * high.less_than_one);  // 1 − h
  const V plus = fma(v.rest, select(straddling, low.less_than_one, more), v.share * (V(1) + high.h));      // 1 + h
  // r² = d²/(1 − h²), and 1/r beside it.
  const V up = constant<V>(product_scale);
  const V up_d2 = up * line.d2, up_cosine2 = up * minus * plus;
  const V quotient = V(1) / sqrt(up_d2 * up_cosine2);
  const V r = up_d2 * quotient, inverse_r = up_cosine2 * quotient;
  const V across = min(max(r * fma(v.rest, low.h, v.share * high.h), y0), y1);

  // h − h0 = d² rise/(r0 r1). The second step is (y − y0) = (h − h0)/d² · r r0 (y r0 + y0 r)/(y + y0), whose last
  // quotient is 0/0 for y = y0 = 0 in this form alone.
  const V rise = v.share * e_y * (y0 + y1) / fma(y1, low.r, y0 * high.r);
  const V y = r * fma(line.d2 * (low.inverse_r * high.inverse_r), rise, low.h);
  const V sum_r = r + low.r, sum_y = y + y0;
  const V slope = V(2) * fma(r, low.r, y * y0) / fma(sum_r, sum_r, sum_y * sum_y);
  const V step = min(e_y, rise * r * high.inverse_r * (sum_r * slope));
  return {{select(straddling, across, y0 + step), select(straddling, across - y0, step)}, r, inverse_r};
}

template <class V>
inline Square<V> SphericalRectangle<V>::invert(const V (&direction)[3]) const {
  const RectangleHit<V> hit = strips_.hit(direction);
  const V u = u_of(hit.x), v = v_of(hit.x, hit.y);
  const Mask<V> inside = hit.inside && valid_;
  return {select(inside, clamp_variate(select(strips_.flip_x, V(1) - u, u)), V(-1)),
          select(inside, clamp_variate(select(strips_.flip_y, V(1) - v, v)), V(-1))};
}

template <class V>
inline V SphericalRectangle<V>::u_of(V x) const {
  const Mask<V> on_left = x < V(0);
  const Strip<V>&left = strips_.left, &right = strips_.right;
  const auto pick = [&](V of_left, V of_right) { return select(on_left, of_left, of_right); };
  const StripEdge<V> a = {pick(left.near.x, right.near.x), pick(left.near.r0, right.near.r0),
                          pick(left.near.r1, right.near.r1)};
  const V width = min(abs(x) - a.x, pick(left.width, right.width));
  const StripEnds<V> ends = {a, strips_.edge_at(abs(x)), width, pick(left.w_near, right.w_near)};
  const V growth = ends.growth(V(1) / (ends.sum0() * ends.sum1()));
  const V opposite = growth, adjacent = fma(ends.w_near, fma(ends.w_near, strips_.N, growth), strips_.N);
  const V part = V(2) * right_angles(opposite, adjacent, opposite, adjacent).first.angle;
  return (left.area() + pick(-part, part)) / omega_;
}

template <class V>
inline V SphericalRectangle<V>::v_of(V x, V y) const {
  const RectangleLine<V> line(strips_, x);
  const V y0 = strips_.y0, y1 = strips_.y1;
  const V r = sqrt(fma(y, y, line.d2));
  const V across = (y / r - line.low.h) / (line.high.h - line.low.h);
  // `rise` of y over that of y1, in the terms of y_of.
  const V sum_r = r + line.low.r, sum_y = y + y0;
  const V slope = V(2) * fma(r, line.low.r, y * y0) / fma(sum_r, sum_r, sum_y * sum_y);
  const V rise = (y - y0) * line.high.r / (sum_r * slope * r);
  const V rise_of_all = strips_.e_y * (y0 + y1) / fma(y1, line.low.r, y0 * line.high.r);
  return select(y0 < V(0), across, rise / rise_of_all);
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
