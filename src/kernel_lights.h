// A light as the kernels see it: the numbers that are kept of it (light_constants.h) and what follows from them, each
// in a vector. Either all lanes have the same light, or every lane has its own; the text that reads it is the same.
//
// What follows is worked out here, in the kernels' own arithmetic, so that a lane's bits do not depend on which of the
// two it was, and so that little needs to be kept of a light.
#pragma once

#include "compensated.h"
#include "kernel_table.h"

namespace hatbox::HATBOX_ISA {
namespace {

template <class V>
struct DiskLight : DiskConstantsOf<V> {
  using Kept = DiskConstantsOf<V>;

  DiskLight() = default;
  explicit DiskLight(const Kept& kept) : Kept(kept) { derive(); }

  void derive() {}
};

/// With the table that its maps are read from (eta_table.h).
template <class V>
struct TabulatedDiskLight : DiskLight<V> {
  TabulatedDiskLight() = default;
  TabulatedDiskLight(const DiskConstantsOf<V>& disk, const float* table, std::size_t rows)
      : DiskLight<V>(disk), coefficients(table), resolution(rows) {}

  const float* coefficients;
  std::size_t resolution;
};

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
    inverse_area = V(1) / in_units[0] / in_units[1];
  }

  V inverse_length[2];
  V unit;  // the power of two at or next below the longer edge: what area sampling measures in, so as not to overflow
  V inverse_unit;
  V edges[2][3];   // in units
  V inverse_area;  // in units
};

/// Lengths are in units of `unit`, a power of two near the longest side. Side i lies opposite vertex i and runs
/// counterclockwise.
template <class V>
struct TriangleLight : TriangleConstantsOf<V> {
  using Kept = TriangleConstantsOf<V>;

  TriangleLight() = default;
  explicit TriangleLight(const Kept& kept) : Kept(kept) { derive(); }

  void derive() {
    const V longest = this->base * max(max(abs(this->apex[0]), this->apex[1]), V(1));
    unit = power_of_two(longest);
    inverse_unit = inverse_power_of_two(longest);
    base_in_units = this->base * inverse_unit;
    apex_x = this->apex[0] * base_in_units;
    apex_y = this->apex[1] * base_in_units;
    from_b = two_sum(apex_x, -base_in_units);
    side_length[0] = sqrt(fma(from_b.high, from_b.high, apex_y * apex_y));
    side_length[1] = sqrt(fma(apex_x, apex_x, apex_y * apex_y));
    side_length[2] = base_in_units;
    doubled_area = base_in_units * apex_y;
    inverse_area = V(2) / doubled_area;
    for (int i = 0; i < 3; ++i) {
      edges[0][i] = this->axes_hi[0][i] * base_in_units;
      edges[1][i] = fma(this->axes_hi[0][i], apex_x, this->axes_hi[1][i] * apex_y);
    }
  }

  V unit, inverse_unit;
  V base_in_units;
  V apex_x, apex_y;  // of c − a
  Pair<V> from_b;    // x of c − b
  V side_length[3];
  V doubled_area, inverse_area;
  V edges[2][3];  // b − a and c − a along the world's axes
};

/// The light that kernels make of constants.
template <class V, class Constants>
struct KernelLight;
template <class V>
struct KernelLight<V, DiskConstants> {
  using type = DiskLight<V>;
};
template <class V>
struct KernelLight<V, TabulatedDisk> {
  using type = TabulatedDiskLight<V>;
};
template <class V>
struct KernelLight<V, EllipseConstants> {
  using type = EllipseLight<V>;
};
template <class V>
struct KernelLight<V, RectangleConstants> {
  using type = RectangleLight<V>;
};
template <class V>
struct KernelLight<V, TriangleConstants> {
  using type = TriangleLight<V>;
};

}  // namespace
}  // namespace hatbox::HATBOX_ISA
