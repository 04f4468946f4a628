// A segment of a ray as a pivot sees it: how far the pivot's foot on the ray is from where the segment begins, and how
// far the pivot is off the ray. Both are small differences of large numbers where the pivot or the ray's origin is far
// away; all that cancels is carried at twice the precision, so they are those of the inputs as given.
#pragma once

#include "compensated.h"
#include "light_sample.h"

namespace hatbox::HATBOX_ISA {
namespace {

template <class V>
struct Ray {
  V origin[3], direction[3], t_min, t_max;

  /// All of it is finite but, maybe, t_max, and some of it is left.
  Mask<V> has_length() const { return is_finite(t_min) && (t_max > t_min); }
};

/// In units of t, which are the direction's length.
template <class V>
struct SegmentView {
  HATBOX_INLINE SegmentView(const Ray<V>& ray, const V (&pivot)[3]);

  Pair<V> start;  // of the segment, from the pivot's foot: t_min − (pivot − origin)·d / d²
  V distance;     // of the pivot from the ray: |(pivot − origin) × d| / d²
  Mask<V> valid;
};

/// x·y − z·w, of x and z of twice the precision.
template <class V>
HATBOX_INLINE inline V difference_of_products(const Pair<V>& x, V y, const Pair<V>& z, V w) {
  const Pair<V> xy = two_product(x.high, y), zw = two_product(z.high, w);
  const Pair<V> difference = two_sum(xy.high, -zw.high);
  const V low = (xy.low - zw.low) + difference.low;
  return difference.high + (low + fma(x.low, y, -(z.low * w)));
}

/// √(x² + y² + z²), also where the squares would overflow or underflow.
template <class V>
HATBOX_INLINE inline V safe_length(const V (&x)[3]) {
  const V largest = max(max(abs(x[0]), abs(x[1])), abs(x[2]));
  const V scale = select(largest >= constant<V>(smallest_normal<V>), largest, V(1));
  const V down = inverse_power_of_two(scale);
  V sum = V(0);
  for (const V& component : x) sum = fma(component * down, component * down, sum);
  return sqrt(sum) * power_of_two(scale);
}

template <class V>
HATBOX_INLINE inline SegmentView<V>::SegmentView(const Ray<V>& ray, const V (&pivot)[3]) {
  const V(&d)[3] = ray.direction;
  Pair<V> q[3];  // from the segment's start to the pivot
  Pair<V> d_as_pair[3];
  for (int i = 0; i < 3; ++i) {
    const Pair<V> w = two_sum(pivot[i], -ray.origin[i]);
    const Pair<V> way = two_product(ray.t_min, d[i]);
    const Pair<V> difference = two_sum(w.high, -way.high);
    q[i].high = difference.high;
    q[i].low = difference.low + (w.low - way.low);
    d_as_pair[i].high = d[i];
    d_as_pair[i].low = V(0);
  }
  const Pair<V> dd = dot_pair(d_as_pair, d), qd = dot_pair(q, d);
  const V high = -qd.high / dd.high;  // the quotient's rest below: the product is exact, its difference nearly so
  const V rest = fma(-high, dd.high, -qd.high) - fma(high, dd.low, qd.low);
  start.high = high;
  start.low = rest / dd.high;
  const V cross[3] = {difference_of_products(q[1], d[2], q[2], d[1]), difference_of_products(q[2], d[0], q[0], d[2]),
                      difference_of_products(q[0], d[1], q[1], d[0])};
  distance = safe_length(cross) / dd.high;
  valid = honest(ray.has_length(), dd.high) && is_finite(start.high + start.low) && is_finite(distance);
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
