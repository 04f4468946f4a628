// The way from a shading point to a place on a flat light: what area sampling is made of, whatever the light's shape.
#pragma once

#include "light_sample.h"

namespace hatbox::HATBOX_ISA {
namespace {

template <class V>
struct AreaRay {
  /// To origin + s·span_s + t·span_t. Lengths are in units of the light, from the shading point; `density` is that of a
  /// direction at distance 1.
  HATBOX_INLINE AreaRay(const V (&origin)[3], const V (&span_s)[3], const V (&span_t)[3], const Place<V>& place,
                        V density) {
    for (int i = 0; i < 3; ++i) l[i] = fma(V(span_s[i]), place.s, fma(V(span_t[i]), place.t, origin[i]));
    const V distance2 = fma(l[0], l[0], fma(l[1], l[1], l[2] * l[2]));
    clear = distance2 >= constant<V>(smallest_normal<V>);
    distance = sqrt(distance2);
    inverse_distance = distance * (V(1) / distance2);  // the root and the quotient run side by side
    pdf = distance2 * density * distance;
  }

  /// Of a light whose plane is at a height, signed along its normal.
  HATBOX_INLINE LightSample<V> sample(const Place<V>& place, V height, const V& unit, Mask<V> is_given) const {
    LightSample<V> out;
    for (int i = 0; i < 3; ++i) out.direction[i] = l[i] * inverse_distance;
    out.distance = distance * V(unit);
    out.pdf = pdf;
    out.cosine = min(max(-height * inverse_distance, V(-1)), V(1));
    out.place = place;
    out.valid = honest(is_given && clear && is_finite(out.distance), out.pdf);
    return out;
  }

  V pdf_where(Mask<V> on_light) const { return select(honest(on_light && clear, pdf), pdf, V(0)); }

  V l[3];
  V distance, inverse_distance;
  V pdf;
  Mask<V> clear;  // of the place, by more than what underflows when squared
};

/// The density of a direction that ends at this distance; `density` as above.
template <class V>
inline V area_pdf(V distance, V density, Mask<V> hit) {
  const V pdf = distance * distance * density * distance;
  return select(honest(hit, pdf), pdf, V(0));
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
