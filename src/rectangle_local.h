// A rectangle as a shading point sees it: where its sides lie in its own axes, folded into one octant and scaled, and
// which directions hit it. What the maps and the solid angle of rectangles start from.
//
// The reference system of Ureña et al. 2013 (UFK13), §4.1, with two differences. Its x1 = x0 + |edge| is rounded from
// the compensated sum that x0 is rounded from, so that a light is not wider from here than from there; a difference
// c − o or a dot product that is merely rounded costs up to a hundredth of the solid angle next to the light's plane.
// And lengths are scaled by a power of two that brings the largest coordinate into [1, 2): squares and their products
// stay far from under- and overflow, and no bit depends on the scene's unit.
#pragma once

#include "compensated.h"
#include "light_sample.h"
#include "rectangle_light.h"
#include "unit_square.h"

#include <limits>

namespace hatbox::HATBOX_ISA {
namespace {

/// Where the line of a direction meets the rectangle's plane: in folded coordinates, put onto the rectangle.
template <class V>
struct RectangleHit {
  V x, y;
  Mask<V> inside;
};

// Heights above the plane are taken to be at least this share of the largest coordinate: the squares of smaller ones
// would underflow. Beside the light its solid angle is proportional to the height there, and above it is 2π.
inline constexpr double least_height = 0x1p-60;
// What brings a product of two coordinates, so at least the square of least_height, near the middle of float's range: a
// product of two such numbers is a normal float, and one division does for both of their inverses.
inline constexpr double product_scale = 0x1p58;

/// Where the sides of a rectangle lie from the foot of the shading point, along axes that are turned so that
/// x0 + x1 >= 0 and y0 + y1 >= 0, in a unit that brings the largest coordinate into [1, 2).
template <class V>
struct RectangleSides {
  V x0, x1, y0, y1;
  V e_x, e_y;  // the lengths of the edges: x1 − x0, y1 − y0 but for their rounding
  V height;    // of the plane over the shading point, signed along the normal
  V z;         // its size, at least least_height

  /// Whether the foot lies off the light.
  Mask<V> beside() const { return max(x0, y0) > V(0); }

  /// How much smaller the solid angle is than that seen from the height z.
  V shrinking() const { return select(beside(), min(abs(height) * constant<V>(1 / least_height), V(1)), V(1)); }

  /// The height of the plane over the shading point of whom the light is seen as it is from the height z.
  V seen_height() const { return select(beside(), height, copysign(z, height)); }
};

template <class V>
struct RectangleLocal : RectangleSides<V> {
  HATBOX_INLINE RectangleLocal(const RectangleLight<V>& rectangle, V px, V py, V pz);

  /// A sampled direction is right to a few ulp: what these could move inside, is.
  RectangleHit<V> hit(const V (&direction)[3]) const;

  /// The place of an offset from (x0, y0), in scaled lengths.
  Place<V> place_at(V offset_x, V offset_y) const {
    const V s = min(offset_x * (V(light.inverse_length[0]) * scale), V(1));
    const V t = min(offset_y * (V(light.inverse_length[1]) * scale), V(1));
    return {select(flip_x, V(1) - s, s), select(flip_y, V(1) - t, t)};
  }

  const RectangleLight<V>& light;
  Mask<V> valid;           // false in the light's plane and for non-finite points; the rest is then of no use
  Mask<V> flip_x, flip_y;  // whether the axes are turned round
  V scale;                 // world units in a scaled one
};

/// Both ends of an edge along an axis, each rounded but once.
template <class V>
struct Side {
  V low, high;
};

template <class V>
HATBOX_INLINE inline Side<V> side_along(const Pair<V> (&l)[3], const RectangleLight<V>& light, int axis) {
  const Pair<V> near = dot_pair(l, light.axes_hi[axis], light.axes_lo[axis]);
  const Pair<V> far = two_sum(near.high, V(light.length[axis]));
  return {near.high + near.low, far.high + (far.low + near.low)};
}

template <class V>
HATBOX_INLINE inline RectangleLocal<V>::RectangleLocal(const RectangleLight<V>& rectangle, V px, V py, V pz)
    : light(rectangle) {
  const Pair<V> l[3] = {two_sum(V(light.corner[0]), -px), two_sum(V(light.corner[1]), -py),
                        two_sum(V(light.corner[2]), -pz)};
  const Side<V> x = side_along(l, light, 0), y = side_along(l, light, 1);
  const Pair<V> n = dot_pair(l, light.axes_hi[2], light.axes_lo[2]);
  const V world_height = n.high + n.low;
  flip_x = x.low + x.high < V(0);
  flip_y = y.low + y.high < V(0);
  const V largest = max(max(max(abs(x.low), abs(x.high)), max(abs(y.low), abs(y.high))), abs(world_height));
  scale = power_of_two(largest);
  const V down = inverse_power_of_two(largest);
  this->x0 = select(flip_x, -x.high, x.low) * down;
  this->x1 = select(flip_x, -x.low, x.high) * down;
  this->y0 = select(flip_y, -y.high, y.low) * down;
  this->y1 = select(flip_y, -y.low, y.high) * down;
  this->e_x = V(light.length[0]) * down;
  this->e_y = V(light.length[1]) * down;
  this->height = world_height * down;
  this->z = max(abs(this->height), constant<V>(least_height));
  valid = (abs(this->height) > V(0)) && is_finite((x.low + x.high) + (y.low + y.high) + world_height) &&
          (largest >= constant<V>(smallest_normal<V>));
}

// A direction is within a blur of the rectangle if it is, by the sine of its angle, of each of the four planes through
// the shading point and a side.
template <class V>
inline RectangleHit<V> RectangleLocal<V>::hit(const V (&direction)[3]) const {
  const V u = along(light.axes_hi[0], direction), v = along(light.axes_hi[1], direction);
  const V n = along(light.axes_hi[2], direction);
  const V q_x = select(flip_x, -u, u), q_y = select(flip_y, -v, v);
  const V q_n = select(this->height < V(0), -n, n);
  const V blur = constant<V>(8 * std::numeric_limits<Scalar<V>>::epsilon());
  const auto beyond = [&](V q, V side) {  // of the plane through a side, times a length
    return fma(q, this->z, -(side * q_n)) / sqrt(fma(side, side, this->z * this->z));
  };
  const V way = this->z / max(q_n, constant<V>(smallest_normal<V>));
  RectangleHit<V> hit;
  hit.x = max(min(q_x * way, this->x1), this->x0);
  hit.y = max(min(q_y * way, this->y1), this->y0);
  hit.inside = valid && (q_n > -blur) && (beyond(q_x, this->x0) >= -blur) && (beyond(q_x, this->x1) <= blur) &&
               (beyond(q_y, this->y0) >= -blur) && (beyond(q_y, this->y1) <= blur);
  // Seen edge-on the four planes are nearly one: there the outline's two corners, as seen from the foot, bound it.
  const V first_y = select(this->x0 > V(0), this->y1, this->y0), last_x = select(this->y0 > V(0), this->x1, this->x0);
  const auto right_of = [&](V x, V y) { return fma(q_x, y, -(q_y * x)) >= -blur * sqrt(fma(x, x, y * y)); };
  const auto left_of = [&](V x, V y) { return fma(q_y, x, -(q_x * y)) >= -blur * sqrt(fma(x, x, y * y)); };
  hit.inside =
      hit.inside && (!this->beside() || (right_of(this->x0, first_y) && left_of(last_x, this->y0) &&
                                         (!(this->x0 > V(0)) || q_x >= -blur) && (!(this->y0 > V(0)) || q_y >= -blur)));
  return hit;
}

template <class V>
struct Inverses {
  V first, second;
};

/// The inverses of two products of coordinates by one division.
template <class V>
HATBOX_INLINE inline Inverses<V> inverses_of_products(V x0, V y0, V x1, V y1) {
  const V up = constant<V>(product_scale);
  const V first = x0 * up * y0, second = x1 * up * y1;
  const V both = up / (first * second);
  return {second * both, first * both};
}

/// Whether a place is on a rectangle: a sampled one is within 16 ulp of it.
template <class V>
inline Mask<V> on_unit_square(const Place<V>& place) {
  const V margin = constant<V>(16 * std::numeric_limits<Scalar<V>>::epsilon());
  return (min(place.s, place.t) >= -margin) && (max(place.s, place.t) <= V(1) + margin) && is_finite(place.s + place.t);
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
