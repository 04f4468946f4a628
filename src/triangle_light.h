// A triangle as the kernels see it.
#pragma once

#include "compensated.h"
#include "kernel_light.h"
#include "triangle_constants.h"

namespace hatbox::HATBOX_ISA {
namespace {

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

template <class V>
struct KernelLight<V, TriangleConstants> {
  using type = TriangleLight<V>;
};

}  // namespace
}  // namespace hatbox::HATBOX_ISA
