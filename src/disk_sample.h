// What the maps of a disk give for one packet of samples, and the validity rule they share.
#pragma once

#include "disk_cone.h"
#include "unit_square.h"

namespace hatbox::HATBOX_ISA {
namespace {

template <class V>
struct Place {
  V s, t;  // in the disk's own axes and radii
};

template <class V>
struct DiskSample {
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

/// From the disk's axes to the world's.
template <class V>
inline void to_world(const Constants<V>& light, V u, V v, V n, V (&out)[3]) {
  for (int i = 0; i < 3; ++i) {
    out[i] = fma(V(light.axes[0][i]), u, fma(V(light.axes[1][i]), v, V(light.axes[2][i]) * n));
  }
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
