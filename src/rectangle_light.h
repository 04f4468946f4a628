// A rectangle as the kernels see it.
#pragma once

#include "kernel_light.h"
#include "rectangle_constants.h"

namespace hatbox::HATBOX_ISA {
namespace {

template <class V>
struct RectangleLight : RectangleConstantsOf<V> {
  using Kept = RectangleConstantsOf<V>;

  RectangleLight() = default;
  explicit RectangleLight(const Kept& kept) : Kept(kept) { derive(); }

  void derive() {
    const V longer = max(this->length[0], this->length[1]);
    unit = power_of_two(longer);
    inverse_unit = inverse_power_of_two(longer);
    V in_units[2];
    for (int i = 0; i < 2; ++i) {
      inverse_length[i] = V(1) / this->length[i];
      in_units[i] = this->length[i] * inverse_unit;
      for (int axis = 0; axis < 3; ++axis) edges[i][axis] = this->axes_hi[i][axis] * in_units[i];
    }
    area = in_units[0] * in_units[1];
  }

  V inverse_length[2];
  V unit;  // the power of two at or next below the longer edge: what area sampling measures in, so as not to overflow
  V inverse_unit;
  V edges[2][3];  // in units
  V area;         // in units
};

template <class V>
struct KernelLight<V, RectangleConstants> {
  using type = RectangleLight<V>;
};

}  // namespace
}  // namespace hatbox::HATBOX_ISA
