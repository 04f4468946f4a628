// What the library keeps of a light: its frame and its lengths, at most 24 numbers, made once a call or once a
// LightSet, in double, and then rounded. T is float, double for the tests that run the kernels' text in double, or a
// vector of them, a lane a light, in the kernels themselves (kernel_lights.h). Nothing else may be a member: kernels
// fill these structs number by number. The lights must be valid (see their `check`).
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

/// Of its edges the longer one counts as it is, the other without what it has along the longer: an edge that rounding
/// has turned a little moves the light by that share of its shorter side.
///
/// An edge's length is rounded, and its axis stretched by as much, so that the light ends where its edges do: all
/// lengths along the axis are off by up to half an ulp, but what lies next to the far end does not move against it.
template <class T>
struct RectangleConstantsOf {
  T corner[3];      // world units
  T axes_hi[3][3];  // unit vectors but for that, along edge_u, edge_v and edge_u × edge_v, rounded to T …
  T axes_lo[3][3];  // … and what the rounding left
  T length[2];      // of the edges, world units
};
using RectangleConstants = RectangleConstantsOf<float>;

template <class T>
RectangleConstantsOf<T> constants_of(const Rectangle& light);

/// Its plane's axes: x along a → b, y towards c, z the normal.
template <class T>
struct TriangleConstantsOf {
  T vertex[3];               // a, world units
  T axes_hi[3][3];           // unit vectors, rounded to T …
  T x_lo[3], z_lo[3];        // … and what the rounding left of two: y is z × x
  T base_hi, base_lo;        // |b − a|, world units, and what rounding left of it
  T apex_hi[2], apex_lo[2];  // (x, y) of c − a, in bases, and what rounding left of them
};
using TriangleConstants = TriangleConstantsOf<float>;

template <class T>
TriangleConstantsOf<T> constants_of(const Triangle& light);

double longest_side(const Triangle& light);

/// Twice the area over the square of the longest side: the triangle's height on that side, in its lengths. 0 where all
/// vertices are one.
double thinness(const Triangle& light);

/// The constants of a light that passes `check`; throws std::invalid_argument otherwise.
DiskConstants ready(const Disk& light);
EllipseConstants ready(const Ellipse& light);
RectangleConstants ready(const Rectangle& light);
TriangleConstants ready(const Triangle& light);

}  // namespace hatbox
