// The part of a segment of a ray on the front of a plane. The height above the plane is linear in t; its value and its
// slope are carried at twice the precision, so that the side is right wherever the inputs tell it.
#pragma once

#include "segment_view.h"

namespace hatbox::HATBOX_ISA {
namespace {

template <class V>
struct Interval {
  V from, to;
};

/// 0, 0 where nothing is left.
template <class V>
HATBOX_INLINE inline Interval<V> clip_to_front(const Ray<V>& ray, const V (&on_plane)[3], const V (&normal)[3]) {
  const V size = max(max(abs(normal[0]), abs(normal[1])), abs(normal[2]));
  const V down = inverse_power_of_two(size);
  V n[3];
  Pair<V> from_plane[3], d[3];
  V speed = V(0);
  for (int i = 0; i < 3; ++i) {
    n[i] = normal[i] * down;
    from_plane[i] = two_sum(ray.origin[i], -on_plane[i]);
    d[i] = {ray.direction[i], V(0)};
    speed = max(abs(ray.direction[i]), speed);
  }
  const Pair<V> height_sum = dot_pair(from_plane, n), slope_sum = dot_pair(d, n);
  const Pair<V> height = two_sum(height_sum.high, height_sum.low), slope = two_sum(slope_sum.high, slope_sum.low);
  // ±infinity for a ray along the plane, or NaN in it; else a step of Newton's makes it right to an ulp.
  const V first = -height.high / slope.high;
  const V missing = fma(first, slope.high, height.high) + fma(first, slope.low, height.low);
  const V crossing = select(is_finite(first), first - missing / slope.high, first);
  const Mask<V> rising = slope.high > V(0), falling = slope.high < V(0);
  const V from = select(rising, max(crossing, ray.t_min), ray.t_min);
  const V to = select(falling, min(crossing, ray.t_max), ray.t_max);
  const Mask<V> given =
      honest(honest(ray.has_length(), speed), size) && is_finite(height.high) && is_finite(slope.high);
  const Mask<V> left = given && (from < to) && (rising || falling || (height.high > V(0)));
  return {select(left, from, V(0)), select(left, to, V(0))};
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
