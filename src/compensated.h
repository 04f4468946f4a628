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

/// x − y.
template <class V>
inline Pair<V> two_difference(V x, V y) {
  const V difference = x - y;
  const V y_part = difference - x;
  return {difference, (x - (difference - y_part)) - (y + y_part)};
}

/// x · y.
template <class V>
inline Pair<V> two_product(V x, V y) {
  const V product = x * y;
  return {product, fma(x, y, -product)};
}

/// a · b for a vector of pairs and one of broadcast pairs, as if computed in twice the precision and then rounded
/// (Ogita, Rump and Oishi 2005, Dot2, with the low parts carried to first order).
template <class V>
inline V dot(const Pair<V> (&a)[3], const Scalar<V> (&b_high)[3], const Scalar<V> (&b_low)[3]) {
  const V b0 = V(b_high[0]), b1 = V(b_high[1]), b2 = V(b_high[2]);
  const Pair<V> p0 = two_product(a[0].high, b0);
  const Pair<V> p1 = two_product(a[1].high, b1);
  const Pair<V> p2 = two_product(a[2].high, b2);
  const Pair<V> s1 = two_sum(p0.high, p1.high);
  const Pair<V> s2 = two_sum(s1.high, p2.high);
  V low = (p0.low + p1.low) + p2.low + (s1.low + s2.low);
  low = fma(a[0].high, V(b_low[0]), fma(a[0].low, b0, low));
  low = fma(a[1].high, V(b_low[1]), fma(a[1].low, b1, low));
  low = fma(a[2].high, V(b_low[2]), fma(a[2].low, b2, low));
  return s2.high + low;
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
