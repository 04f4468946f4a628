// Error-free sums and products, and the dot product made of them: where a plain one would cancel, these keep what the
// inputs determine. Exact barring overflow and underflow. Needs -ffp-contract=off and no reassociation.
#pragma once

#include "fma.h"

namespace hatbox::HATBOX_ISA {
namespace {

/// An unevaluated sum: high + low, with |low| at most half an ulp of high.
template <class V>
struct Pair {
  V high, low;
};

/// x + y (Knuth's TwoSum).
template <class V>
inline Pair<V> two_sum(V x, V y) {
  const V sum = x + y;
  const V y_part = sum - x;
  return {sum, (x - (sum - y_part)) + (y - y_part)};
}

/// x · y.
template <class V>
inline Pair<V> two_product(V x, V y) {
  const V product = x * y;
  return {product, fma(x, y, -product)};
}

/// x + y of twice the precision, rounded to that.
template <class V>
HATBOX_INLINE inline Pair<V> sum(const Pair<V>& x, const Pair<V>& y) {
  const Pair<V> high = two_sum(x.high, y.high);
  return two_sum(high.high, high.low + (x.low + y.low));
}

/// x · y of twice the precision, rounded to that.
template <class V>
HATBOX_INLINE inline Pair<V> product(const Pair<V>& x, const Pair<V>& y) {
  const Pair<V> high = two_product(x.high, y.high);
  return two_sum(high.high, high.low + fma(x.high, y.low, x.low * y.high));
}

/// a · b as if computed in twice the precision: an unevaluated sum (Ogita, Rump and Oishi 2005, Dot2).
template <class V>
HATBOX_INLINE inline Pair<V> dot_pair(const V (&a)[3], const V (&b)[3]) {
  const Pair<V> p0 = two_product(a[0], b[0]);
  const Pair<V> p1 = two_product(a[1], b[1]);
  const Pair<V> p2 = two_product(a[2], b[2]);
  const Pair<V> s1 = two_sum(p0.high, p1.high);
  const Pair<V> s2 = two_sum(s1.high, p2.high);
  return {s2.high, (p0.low + p1.low) + p2.low + (s1.low + s2.low)};
}

/// The same, a of twice the precision.
template <class V>
HATBOX_INLINE inline Pair<V> dot_pair(const Pair<V> (&a)[3], const V (&b)[3]) {
  auto [high, low] = dot_pair({a[0].high, a[1].high, a[2].high}, b);
  for (int i = 0; i < 3; ++i) low = fma(a[i].low, b[i], low);
  return {high, low};
}

/// The same, both of twice the precision.
template <class V>
HATBOX_INLINE inline Pair<V> dot_pair(const Pair<V> (&a)[3], const V (&b_high)[3], const V (&b_low)[3]) {
  auto [high, low] = dot_pair({a[0].high, a[1].high, a[2].high}, b_high);
  for (int i = 0; i < 3; ++i) low = fma(a[i].high, b_low[i], fma(a[i].low, b_high[i], low));
  return {high, low};
}

/// a · b, b of twice the precision, rounded. The low part of b is carried to first order.
template <class V>
HATBOX_INLINE inline V dot(const V (&a)[3], const V (&b_high)[3], const V (&b_low)[3]) {
  auto [high, low] = dot_pair(a, b_high);
  for (int i = 0; i < 3; ++i) low = fma(a[i], b_low[i], low);
  return high + low;
}

/// √(x² + y²), also where the squares would underflow.
template <class V>
HATBOX_INLINE inline V length_of_small(V x, V y) {
  const Mask<V> tiny = max(abs(x), abs(y)) < constant<V>(0x1p-40);
  const V up = select(tiny, constant<V>(0x1p64), V(1)), down = select(tiny, constant<V>(0x1p-64), V(1));
  const V scaled_x = x * up, scaled_y = y * up;
  return sqrt(fma(scaled_x, scaled_x, scaled_y * scaled_y)) * down;
}

/// The same, also where the squares would overflow, for a y that does not count beside an x of more than 2^50: one of
/// the order of its root.
template <class V>
HATBOX_INLINE inline V length_with_root(V x, V y) {
  return select(abs(x) < constant<V>(0x1p50), length_of_small(x, y), abs(x));
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
