// What is kept of an elliptical disk; see light_rows.h.
#pragma once

#include <hatbox/lights.h>

namespace hatbox {

template <class T>
struct EllipseConstantsOf {
  T center[3];                   // world units
  T axes[3][3];                  // unit vectors along the longer and the shorter semi-axis, and the normal
  T normal_lo[3];                // what rounding left of the normal
  T radius;                      // the longer semi-axis, world units
  T inverse_unit;                // of the power of two at or next below it
  T per_unit, shorter_per_unit;  // unit over the longer and over the shorter semi-axis
  T ratio, inverse_ratio;        // r, the shorter semi-axis over the longer
  T flattening;                  // 1 − r²
  T swapped;                     // 1 if semi_axis_v is the longer one, else 0
};
using EllipseConstants = EllipseConstantsOf<float>;

template <class T>
EllipseConstantsOf<T> constants_of(const Ellipse& light);

/// Of a light that passes `check`; throws std::invalid_argument otherwise.
EllipseConstants ready(const Ellipse& light);

}  // namespace hatbox
