// An elliptical disk as the kernels see it.
#pragma once

#include "ellipse_constants.h"
#include "kernel_light.h"

namespace hatbox::HATBOX_ISA {
namespace {

template <class V>
struct EllipseLight : EllipseConstantsOf<V> {
  using Kept = EllipseConstantsOf<V>;

  EllipseLight() = default;
  explicit EllipseLight(const Kept& kept) : Kept(kept) { derive(); }

  void derive() {
    inverse_radius = this->per_unit * this->inverse_unit;
    ratio2 = this->ratio * this->ratio;
    flattening2 = this->flattening * this->flattening;
    for (int i = 0; i < 3; ++i) shorter_axis[i] = this->axes[1][i] * this->ratio;
  }

  V inverse_radius;
  V ratio2, flattening2;
  V shorter_axis[3];  // in units of the longer one
};

template <class V>
inline const V& shorter_per_unit(const EllipseLight<V>& light) {
  return light.shorter_per_unit;
}

template <class V>
struct KernelLight<V, EllipseConstants> {
  using type = EllipseLight<V>;
};

}  // namespace
}  // namespace hatbox::HATBOX_ISA
