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
    area = in_units[0] * in_units[1];
  }

  V inverse_length[2];
  V unit;  // the power of two at or next below the longer edge: what area sampling measures in, so as not to overflow
  V inverse_unit;
  V edges[2][3];  // in units
  V area;         // in units
};

/// Lengths are in units of `unit`, a power of two near the longest side. Side i lies opposite vertex i and runs
/// counterclockwise.
template <class V>
struct TriangleLight : TriangleConstantsOf<V> {
  using Kept = TriangleConstantsOf<V>;

  TriangleLight() = default;
  explicit TriangleLight(const Kept& kept) : Kept(kept) { derive(); }

  void derive() {
    const V longest = this->base_hi * max(max(abs(this->apex_hi[0]), this->apex_hi[1]), V(1));
    unit = power_of_two(longest);
    inverse_unit = inverse_power_of_two(longest);
    base.high = this->base_hi * inverse_unit;
    base.low = this->base_lo * inverse_unit;
    apex_x = product(Pair<V>{this->apex_hi[0], this->apex_lo[0]}, base);
    apex_y = product(Pair<V>{this->apex_hi[1], this->apex_lo[1]}, base);
    from_b = sum(apex_x, Pair<V>{-base.high, -base.low});
    side_length[0] = sqrt(fma(from_b.high, from_b.high, apex_y.high * apex_y.high));
    side_length[1] = sqrt(fma(apex_x.high, apex_x.high, apex_y.high * apex_y.high));
    side_length[2] = base.high;
    doubled_area = base.high * apex_y.high;
    area = V(0.5) * doubled_area;
    for (int i = 0; i < 3; ++i) {
      axes_lo[0][i] = this->x_lo[i];
      axes_lo[1][i] = rest_of_y((i + 1) % 3, (i + 2) % 3, i);
      axes_lo[2][i] = this->z_lo[i];
      edges[0][i] = this->axes_hi[0][i] * base.high;
      edges[1][i] = fma(this->axes_hi[0][i], apex_x.high, this->axes_hi[1][i] * apex_y.high);
    }
  }

  /// What rounding left of component i of y = z × x, which is z_j x_k − z_k x_j.
  V rest_of_y(int j, int k, int i) const {
    const V(&x)[3] = this->axes_hi[0], (&z)[3] = this->axes_hi[2];
    const Pair<V> zx = two_product(z[j], x[k]), xz = two_product(z[k], x[j]);
    const Pair<V> difference = two_sum(zx.high, -xz.high);
    const V low = fma(z[j], this->x_lo[k], this->z_lo[j] * x[k]) - fma(z[k], this->x_lo[j], this->z_lo[k] * x[j]);
    return (difference.high - this->axes_hi[1][i]) + (difference.low + ((zx.low - xz.low) + low));
  }

  V unit, inverse_unit;
  V axes_lo[3][3];
  Pair<V> base;
  Pair<V> apex_x, apex_y;  // of c − a
  Pair<V> from_b;          // x of c − b
  V side_length[3];
  V doubled_area, area;
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
