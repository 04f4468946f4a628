// Carlson's integrals over all floats: arguments are scaled by powers of two, so that nothing on the way to a normal
// result over- or underflows, and a lane whose arguments are outside the domain is NaN.
#pragma once

#include "carlson.h"

namespace hatbox::HATBOX_ISA {
namespace {

template <class V>
inline V not_a_number() {
  return constant<V>(std::numeric_limits<double>::quiet_NaN());
}

/// Not negative, finite, no NaN, and no two of them 0. Their sum must not overflow.
template <class V>
HATBOX_INLINE inline Mask<V> in_domain(V x, V y, V z) {
  return (min(min(x, y), z) >= V(0)) && (min(min(x + y, y + z), z + x) > V(0)) &&
         (x + y + z < constant<V>(infinity<V>));
}

/// For R_F and R_C: what the arguments are multiplied by, so that sums do not overflow and small ones stay normal
/// floats, and what the result is.
template <class V>
struct FirstKindScale {
  V arguments, result;

  HATBOX_INLINE explicit FirstKindScale(V largest) {
    const Mask<V> low = largest < V(0x1p-60f);
    arguments = select(low, V(0x1p46f), V(0x1p-2f));
    result = select(low, V(0x1p23f), V(0x1p-1f));
  }
};

/// For R_D and R_J: a factor r with 2^78 <= r² largest < 2^80. R(x, …) = r³ R(r²x, …), and R_F = r R_F(r²x, …).
/// Then the product of three sums of roots is below 2^123, and arguments of 2^-200 times the largest are normal floats.
template <class V>
struct ThirdKindScale {
  V r;

  HATBOX_INLINE explicit ThirdKindScale(V largest) : r(V(0x1p39f) / power_of_two(sqrt(largest))) {}
  HATBOX_INLINE Mask<V> is_finite() const { return r > V(0); }
  /// One that was not 0 stays so, since two zeros are outside the domain.
  HATBOX_INLINE V operator()(V argument) const { return select(argument > V(0), positive(argument), argument); }
  HATBOX_INLINE V positive(V argument) const { return max(argument * r * r, constant<V>(smallest_normal<V>)); }
  /// Of the scaled arguments' integral. Three factors in turn: the result passes an end of its range once at most.
  HATBOX_INLINE V undone(V integral) const { return integral * r * r * r; }
};

template <class V>
HATBOX_INLINE inline V or_nan(Mask<V> valid, V value) {
  return select(valid, value, not_a_number<V>());
}

template <class V>
HATBOX_INLINE inline V carlson_rf(V x, V y, V z) {
  const FirstKindScale<V> scale(max(max(x, y), z));
  const Mask<V> not_negative = min(min(x, y), z) >= V(0);  // which what is scaled may be, where denormals are flushed
  x = x * scale.arguments;
  y = y * scale.arguments;
  z = z * scale.arguments;
  const Mask<V> valid = not_negative && in_domain(x, y, z);
  return or_nan(valid, duplicate_rf(valid, x, y, z) * scale.result);
}

template <class V>
HATBOX_INLINE inline V carlson_rc(V x, V y) {
  const FirstKindScale<V> scale(max(x, y));
  const Mask<V> not_negative = min(x, y) >= V(0);
  x = x * scale.arguments;
  y = y * scale.arguments;
  const Mask<V> valid = not_negative && (y > V(0)) && (x + y < constant<V>(infinity<V>));
  return or_nan(valid, duplicate_rc(valid, x, y) * scale.result);
}

/// R_F(x, y, z) and R_D(x, y, z), both NaN where R_D is.
template <Wanted wanted, class V>
HATBOX_INLINE inline FirstAndThird<V> carlson_rf_rd(V x, V y, V z) {
  const ThirdKindScale<V> scale(max(max(x, y), z));
  const Mask<V> valid = scale.is_finite() && (z > V(0));
  x = scale(x);
  y = scale(y);
  z = scale(z);
  const Mask<V> inside = valid && in_domain(x, y, z);
  const FirstAndThird<V> r = duplicate_rf_rd<wanted>(inside, x, y, z);
  return {or_nan(inside, r.rf * scale.r), or_nan(inside, scale.undone(r.rj))};
}

/// R_F(x, y, z) and R_J(x, y, z, p), both NaN where R_J is.
template <class V>
HATBOX_INLINE inline FirstAndThird<V> carlson_rf_rj(V x, V y, V z, V p) {
  const ThirdKindScale<V> scale(max(max(max(x, y), z), p));
  const Mask<V> valid = scale.is_finite() && (p > V(0));
  x = scale(x);
  y = scale(y);
  z = scale(z);
  const Mask<V> inside = valid && in_domain(x, y, z);
  const FirstAndThird<V> r = duplicate_rf_rj<Wanted::both>(inside, x, y, z, scale.positive(p));
  return {or_nan(inside, r.rf * scale.r), or_nan(inside, scale.undone(r.rj))};
}

/// R_J. Duplication brings a p far above x, y and z down by 4 a step only; there it is, with x the largest of them,
///   (p − x) R_J(x, y, z, p) = 3 (R_F(x, y, z) − R_C(yz/x, pq/x)) − (q − x) R_J(x, y, z, q)
///   q − x = (x − y)(x − z)/(p − x)
/// (DLMF 19.21.12), whose first term is more than ten times the others.
template <class V>
HATBOX_INLINE inline V carlson_rj(V x, V y, V z, V p) {
  const V high = max(max(x, y), z), low = min(min(x, y), z);
  const Mask<V> far = (p > V(4096) * high) && (p < constant<V>(infinity<V>));
  const V middle = max(min(x, y), min(max(x, y), z));
  const V from_p = p - high;
  const V from_q = (high - middle) * ((high - low) / from_p);
  const V q = select(far, high + from_q, p);
  const ThirdKindScale<V> scale(max(high, q));
  const V X = scale(x), Y = scale(y), Z = scale(z);
  const Mask<V> valid = scale.is_finite() && (p > V(0)) && in_domain(X, Y, Z);
  const V rj = duplicate_rf_rj<Wanted::third>(valid, X, Y, Z, scale.positive(q)).rj;
  const V result = or_nan(valid, scale.undone(rj));
  if (!any(far)) return result;
  const V product = min(p * (q / high), constant<V>(std::numeric_limits<Scalar<V>>::max()));
  const V difference = carlson_rf(x, y, z) - carlson_rc(low * (middle / high), product);
  const V rest = from_q * scale.r * scale.r * rj * scale.r;  // R_J itself could overflow here
  return select(far && valid, fma(V(3), difference, -rest) / from_p, result);
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
