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

/// Not negative, finite, no NaN, and no two of them 0.
template <class V>
HATBOX_INLINE inline Mask<V> in_domain(V x, V y, V z) {
  return (x >= V(0)) && (y >= V(0)) && (z >= V(0)) && (max(max(x, y), z) < constant<V>(infinity<V>)) &&
         (x + y > V(0)) && (y + z > V(0)) && (z + x > V(0));
}

/// What scaling made of an argument: one that was not 0 stays so, since two zeros are outside the domain.
template <class V>
HATBOX_INLINE inline V kept_positive(V argument, V scaled, double floor) {
  return select(argument > V(0), max(scaled, constant<V>(floor)), V(0));
}

/// For R_F and R_C: x ↦ x·arguments, R ↦ R·result. What is near the ends of the range is moved inwards.
template <class V>
struct FirstKindScale {
  V arguments, result;

  HATBOX_INLINE explicit FirstKindScale(V largest) {
    const Mask<V> high = largest > V(0x1p120f), low = largest < V(0x1p-80f);
    arguments = select(high, V(0x1p-8f), select(low, V(0x1p48f), V(1)));
    result = select(high, V(0x1p-4f), select(low, V(0x1p24f), V(1)));
  }
  HATBOX_INLINE V operator()(Mask<V> valid, V argument) const {
    constexpr double floor = std::numeric_limits<Scalar<V>>::denorm_min();
    return select(valid, kept_positive(argument, argument * arguments, floor), V(1));
  }
};

/// For R_D and R_J: a factor r with 2^78 <= r² largest < 2^80. R(x, …) = r³ R(r²x, …), and R_F = r R_F(r²x, …).
/// Then the product of three sums of roots is below 2^123, and arguments of 2^-200 times the largest are normal floats.
template <class V>
struct ThirdKindScale {
  V r;

  HATBOX_INLINE explicit ThirdKindScale(V largest) : r(V(0x1p39f) / power_of_two(sqrt(largest))) {}
  HATBOX_INLINE V operator()(Mask<V> valid, V argument) const {
    return select(valid, kept_positive(argument, argument * r * r, smallest_normal<V>), V(1));
  }
  /// Of the scaled arguments' integrals. Three factors in turn: the result passes its range's ends once at most.
  HATBOX_INLINE FirstAndThird<V> undone(Mask<V> valid, const FirstAndThird<V>& integrals) const {
    return {select(valid, integrals.rf * r, not_a_number<V>()),
            select(valid, integrals.rj * r * r * r, not_a_number<V>())};
  }
};

template <class V>
HATBOX_INLINE inline V carlson_rf(V x, V y, V z) {
  const Mask<V> valid = in_domain(x, y, z);
  const FirstKindScale<V> scale(max(max(x, y), z));
  const V scaled = duplicate_rf(scale(valid, x), scale(valid, y), scale(valid, z));
  return select(valid, scaled * scale.result, not_a_number<V>());
}

template <class V>
HATBOX_INLINE inline V carlson_rc(V x, V y) {
  const Mask<V> valid = in_domain(x, y, y);
  const FirstKindScale<V> scale(max(x, y));
  const V scaled = duplicate_rc(scale(valid, x), scale(valid, y));
  return select(valid, scaled * scale.result, not_a_number<V>());
}

/// R_F(x, y, z) and R_D(x, y, z), both NaN where R_D is.
template <Wanted wanted, class V>
HATBOX_INLINE inline FirstAndThird<V> carlson_rf_rd(V x, V y, V z) {
  const Mask<V> valid = in_domain(x, y, z) && (z > V(0));
  const ThirdKindScale<V> scale(max(max(x, y), z));
  return scale.undone(valid, duplicate_rf_rd<wanted>(scale(valid, x), scale(valid, y), scale(valid, z)));
}

/// R_F(x, y, z) and R_J(x, y, z, p), both NaN where R_J is.
template <class V>
HATBOX_INLINE inline FirstAndThird<V> carlson_rf_rj(V x, V y, V z, V p) {
  const Mask<V> valid = in_domain(x, y, z) && (p > V(0)) && (p < constant<V>(infinity<V>));
  const ThirdKindScale<V> scale(max(max(max(x, y), z), p));
  return scale.undone(
      valid, duplicate_rf_rj<Wanted::both>(scale(valid, x), scale(valid, y), scale(valid, z), scale(valid, p)));
}

/// R_J. Duplication brings a p far above x, y and z down by 4 a step only; there it is, with x the largest of them,
///   (p − x) R_J(x, y, z, p) = 3 (R_F(x, y, z) − R_C(yz/x, pq/x)) − (q − x) R_J(x, y, z, q),  q − x = (x − y)(x − z)/(p
///   − x)
/// (DLMF 19.21.12), whose first term is more than ten times the others.
template <class V>
HATBOX_INLINE inline V carlson_rj(V x, V y, V z, V p) {
  const V high = max(max(x, y), z), low = min(min(x, y), z);
  const Mask<V> valid = in_domain(x, y, z) && (p > V(0)) && (p < constant<V>(infinity<V>));
  const Mask<V> far = valid && (p > V(4096) * high);
  const V middle = max(min(x, y), min(max(x, y), z));
  const V from_p = p - high;
  const V from_q = (high - middle) * ((high - low) / from_p);
  const V q = select(far, high + from_q, p);
  const ThirdKindScale<V> scale(max(high, q));
  const V rj = duplicate_rf_rj<Wanted::third>(scale(valid, x), scale(valid, y), scale(valid, z), scale(valid, q)).rj;
  const V result = select(valid, rj * scale.r * scale.r * scale.r, not_a_number<V>());
  if (!any(far)) return result;
  const V product = min(p * (q / high), constant<V>(std::numeric_limits<Scalar<V>>::max()));
  const V difference = carlson_rf(x, y, z) - carlson_rc(low * (middle / high), product);
  const V rest = from_q * scale.r * scale.r * rj * scale.r;  // R_J itself could overflow here
  return select(far, fma(V(3), difference, -rest) / from_p, result);
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
