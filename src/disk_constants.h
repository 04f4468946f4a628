// What is kept of a disk; see light_rows.h.
#pragma once

#include <hatbox/lights.h>

#include <cstddef>

namespace hatbox {

template <class T>
struct DiskConstantsOf {
  T center[3];     // world units
  T axes[3][3];    // rows axis_u, axis_v, normal: unit vectors
  T normal_lo[3];  // what rounding left of the normal
  T radius, inverse_radius;
  T inverse_unit;  // of the power of two at or next below the radius
  T per_unit;      // that over the radius
};
using DiskConstants = DiskConstantsOf<float>;

template <class T>
DiskConstantsOf<T> constants_of(const Disk& light);

/// A disk with the table that its maps are read from (eta_table.h).
struct TabulatedDisk : DiskConstants {
  const float* coefficients;  // resolution² of them
  std::size_t resolution;
};

/// Of a light that passes `check`; throws std::invalid_argument otherwise.
DiskConstants ready(const Disk& light);

}  // namespace hatbox
