// The points of a rectangle as seen, by solid angle, and back. u moves a line x = const over the rectangle, v a point
// along it (UFK13 §4.3 and 4.4), both by the closed forms of rectangle_strips.h instead of the paper's, which cancel.
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

/// The shares of a variate, counted from the other end where the axis is turned round.
template <class V>
HATBOX_INLINE inline Shares<V> shares_of(V variate, Mask<V> flip) {
  const Shares<V> shares = shares_of(variate);
  return {select(flip, shares.rest, shares.share), select(flip, shares.share, shares.rest)};
}

// Seen along a line that all but meets the shading point, 1 − h is as small as least_height². In this unit neither it
// nor its share is a denormal float, which a caller may have flushed to zero, and d²(1 − h²) in its square is none.
inline constexpr double line_scale = 0x1p61;

/// The line x = const, across which y runs: y0 and y1 as seen along it.
template <class V>
struct RectangleLine {
  struct End {
    V r;  // distance from the shading point
    V inverse_r;
    V h;                 // y/r
    V up_less_than_one;  // 1 − |h|, times line_scale
  };

  HATBOX_INLINE RectangleLine(const RectangleSides<V>& sides, V x)
      : d2(fma(x, x, sides.z * sides.z)), up_d2(constant<V>(line_scale) * d2) {
    const V r0 = sqrt(fma(sides.y0, sides.y0, d2)), r1 = sqrt(fma(sides.y1, sides.y1, d2));
    const V sum0 = r0 + abs(sides.y0), sum1 = r1 + abs(sides.y1);
    const Inverses<V> inverse = inverses_of_products(r0, sum0, r1, sum1);
    const auto end = [&](V y, V r, V sum, V inverse_product) HATBOX_INLINE {
      const V inverse_r = sum * inverse_product;
      return End{r, inverse_r, y * inverse_r, up_d2 * inverse_product};
    };
    low = end(sides.y0, r0, sum0, inverse.first);
    high = end(sides.y1, r1, sum1, inverse.second);
  }

  V d2;     // squared distance of the line
  V up_d2;  // times line_scale
  End low, high;
};

/// A coordinate, and its offset from the rectangle's side x0 or y0.
template <class V>
struct Coordinate {
  V value, offset;
};

/// A point of the rectangle: where it is, and its distance from the shading point.
template <class V>
struct RectanglePoint {
  Coordinate<V> x, y;
  V r, inverse_r;
};

template <class V>
class UniformRectangle {
 public:
  HATBOX_INLINE explicit UniformRectangle(const RectangleSides<V>& sides) : strips_(sides), area_(strips_.area()) {}

  V solid_angle() const { return min(constant<V>(2 * pi), area_ * strips_.shrinking()); }
  V seen_height() const { return strips_.seen_height(); }

  /// Whether a distance is a point's own. Beside the light it is that seen from the least height: what is about as near
  /// as that cannot be told from its neighbours.
  Mask<V> tells(V r) const { return !strips_.beside() || (r >= constant<V>(0x1p12 * least_height)); }

  HATBOX_INLINE RectanglePoint<V> point(const Shares<V>& u, const Shares<V>& v) const {
    const Coordinate<V> x = x_of(u);
    return y_of(v, x, RectangleLine<V>(strips_, x.value));
  }

  V u_of(V x) const;
  V v_of(V x, V y) const;

 private:
  HATBOX_INLINE Coordinate<V> x_of(const Shares<V>& u) const;
  HATBOX_INLINE RectanglePoint<V> y_of(const Shares<V>& v, const Coordinate<V>& x, const RectangleLine<V>& line) const;

  RectangleStrips<V> strips_;
  V area_;  // seen from the height z
};

template <class V>
HATBOX_INLINE inline Coordinate<V> UniformRectangle<V>::x_of(const Shares<V>& u) const {
  const V before = u.share * area_, left_area = strips_.left.area();
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
  const V theta_u = V(0.5) * abs(before - left_area), theta_f = V(0.5) * pick(before, u.rest * area_);
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
HATBOX_INLINE inline RectanglePoint<V> UniformRectangle<V>::y_of(const Shares<V>& v, const Coordinate<V>& x,
                                                                 const RectangleLine<V>& line) const {
  const auto &low = line.low, &high = line.high;
  const V y0 = strips_.y0, y1 = strips_.y1, e_y = strips_.e_y;
  const Mask<V> straddling = y0 < V(0);
  const V up = constant<V>(line_scale);
  const V up_more = fma(up, abs(low.h), up);
  const V up_minus = fma(v.rest, select(straddling, up_more, low.up_less_than_one), v.share * high.up_less_than_one);
  const V up_plus = fma(v.rest, select(straddling, low.up_less_than_one, up_more), v.share * fma(up, high.h, up));
  // r² = d²/((1 − h)(1 + h)), and 1/r beside it.
  const V up2_cosine2 = up_minus * up_plus;
  const V quotient = V(1) / sqrt(line.d2 * up2_cosine2);
  const V r = line.up_d2 * quotient, inverse_r = constant<V>(1 / line_scale) * up2_cosine2 * quotient;
  const V across = min(max(r * fma(v.rest, low.h, v.share * high.h), y0), y1);

  // h − h0 = d² rise/(r0 r1). The second step is (y − y0) = (h − h0)/d² · r r0 (y r0 + y0 r)/(y + y0), whose last
  // quotient is 0/0 for y = y0 = 0 in this form alone, and its products of y, which may be denormal, are never rounded.
  const V rise = v.share * e_y * (y0 + y1) / fma(y1, low.r, y0 * high.r);
  const V y = r * fma(line.d2 * (low.inverse_r * high.inverse_r), rise, low.h);
  const V sum_r = r + low.r, sum_y = y + y0;
  const V slope = V(2) * fma(y, y0, r * low.r) / fma(sum_y, sum_y, sum_r * sum_r);
  const V step = min(e_y, rise * r * high.inverse_r * (sum_r * slope));
  return {x, {select(straddling, across, y0 + step), select(straddling, across - y0, step)}, r, inverse_r};
}

template <class V>
inline V UniformRectangle<V>::u_of(V x) const {
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
  return (left.area() + pick(-part, part)) / area_;
}

template <class V>
inline V UniformRectangle<V>::v_of(V x, V y) const {
  const RectangleLine<V> line(strips_, x);
  const V y0 = strips_.y0, y1 = strips_.y1;
  const V r = sqrt(fma(y, y, line.d2));
  const V across = (y / r - line.low.h) / (line.high.h - line.low.h);
  // `rise` of y over that of y1, in the terms of y_of.
  const V sum_r = r + line.low.r, sum_y = y + y0;
  const V slope = V(2) * fma(y, y0, r * line.low.r) / fma(sum_y, sum_y, sum_r * sum_r);
  const V rise = (y - y0) * line.high.r / (sum_r * slope * r);
  const V rise_of_all = strips_.e_y * (y0 + y1) / fma(y1, line.low.r, y0 * line.high.r);
  return select(y0 < V(0), across, rise / rise_of_all);
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
