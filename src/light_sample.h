// What the maps of a light give for one packet of samples, and the validity rule they share.
#pragma once

#include "fma.h"

namespace hatbox::HATBOX_ISA {
namespace {

/// On the light, in its own axes: a disk's or an ellipse's are its semi-axes, so s² + t² <= 1.
template <class V>
struct Place {
  V s, t;
};

template <class V>
struct LightSample {
  V direction[3];  // world space
  V distance;      // world units
  V pdf;
  V cosine;
  Place<V> place;
  Mask<V> valid;
};

/// A lane is good if its input was and its result, a density or a solid angle, neither under- nor overflowed.
template <class V>
inline Mask<V> honest(Mask<V> valid, V result) {
  return valid && (result >= constant<V>(smallest_normal<V>)) && (result < constant<V>(infinity<V>));
}

template <class V>
inline Mask<V> is_finite(V x) {
  return abs(x) < constant<V>(infinity<V>);
}

/// 0, or no number if one of the variates is not finite. (Their sum may overflow.)
template <class V>
inline V given(V u, V v) {
  return V(0) * u + V(0) * v;
}

/// The density of a map that is uniform in a solid angle, and whether a lane has one.
template <class V>
struct UniformDensity {
  HATBOX_INLINE UniformDensity(Mask<V> is_given, V solid_angle) : value(V(1) / solid_angle) {
    valid = honest(honest(is_given, solid_angle), value);
  }

  V where(Mask<V> hit) const { return select(hit && valid, value, V(0)); }

  V value;
  Mask<V> valid;
};

/// A direction given along the light's own axes, in world space, and the cosine.
template <class V>
HATBOX_INLINE inline void set_direction(const V (&axes)[3][3], const V (&along)[3], LightSample<V>& out) {
  for (int i = 0; i < 3; ++i) {
    out.direction[i] = fma(V(axes[0][i]), along[0], fma(V(axes[1][i]), along[1], V(axes[2][i]) * along[2]));
  }
  out.cosine = -along[2];
}

/// The component of a direction along an axis.
template <class V>
inline V along(const V (&axis)[3], const V (&direction)[3]) {
  return fma(direction[0], V(axis[0]), fma(direction[1], V(axis[1]), direction[2] * V(axis[2])));
}

/// Whether a place is on a disk or an ellipse: a sampled one is within 16 ulp of it.
template <class V>
inline Mask<V> on_unit_disk(const Place<V>& place) {
  return fma(place.s, place.s, place.t * place.t) <= constant<V>(1 + 32 * std::numeric_limits<Scalar<V>>::epsilon());
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
