// The way from a shading point to a place on a flat light: what area sampling is made of, whatever the light's shape.
#pragma once

#include "light_sample.h"

namespace hatbox::HATBOX_ISA {
namespace {

template <class V>
struct AreaRay {
  /// To origin + s·span_s + t·span_t. Lengths are in units of the light, from the shading point; `volume` is the
  /// light's area times the height of the point above its plane.
  HATBOX_INLINE AreaRay(const V (&origin)[3], const V (&span_s)[3], const V (&span_t)[3], const Place<V>& place,
                        V volume) {
    for (int i = 0; i < 3; ++i) l[i] = fma(V(span_s[i]), place.s, fma(V(span_t[i]), place.t, origin[i]));
    const V distance2 = fma(l[0], l[0], fma(l[1], l[1], l[2] * l[2]));
    distance = sqrt(distance2);
    const V product = distance * volume;
    // Of squares that have underflowed neither a length nor a direction comes.
    clear = (product >= constant<V>(smallest_normal<V>)) && (distance2 >= constant<V>(least_sum_of_products<V>));
    const V shared = V(1) / product;  // one division for 1/distance and for the density, distance³/volume
    inverse_distance = volume * shared;
    pdf = distance2 * (distance2 * shared);
  }

  /// Of a light whose plane is at a height, signed along its normal.
  /// u, v: what the place was made of.
  HATBOX_INLINE LightSample<V> sample(const Place<V>& place, V height, const V& unit, V u, V v) const {
    LightSample<V> out;
    for (int i = 0; i < 3; ++i) out.direction[i] = l[i] * inverse_distance;
    out.distance = distance * V(unit);
    out.pdf = pdf;
    out.cosine = min(max(-height * inverse_distance, V(-1)), V(1));
    out.place = place;
    out.valid = honest(clear && is_finite(given(u, v) + out.distance), out.pdf);
    return out;
  }

  V pdf_where(Mask<V> on_light) const { return select(honest(on_light && clear, pdf), pdf, V(0)); }

  V l[3];
  V distance, inverse_distance;
  V pdf;
  Mask<V> clear;  // of the light: nothing underflows
};

/// The density of a direction that ends at this distance; `volume` as above.
template <class V>
inline V area_pdf(V distance, V volume, Mask<V> hit) {
  const V pdf = distance * distance / volume * distance;
  return select(honest(hit, pdf), pdf, V(0));
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
