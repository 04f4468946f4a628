// What the kernels know of a light: its frame and its lengths, made ready once a call and in double. T is float; double
// for the tests that run the kernels' text in double. The lights must be valid (see their `check`).
#pragma once

#include <hatbox/lights.h>

#include <cstddef>

namespace hatbox {

template <class T>
struct DiskConstantsOf {
  T center[3];      // world units
  T axes_hi[3][3];  // rows axis_u, axis_v, normal, each unit vector / radius, rounded to T …
  T axes_lo[3][3];  // … and what the rounding left
  T axes[3][3];     // the unit vectors, for the way back to world space
  T radius;
  T inverse_radius;
};
using DiskConstants = DiskConstantsOf<float>;

template <class T>
DiskConstantsOf<T> constants_of(const Disk& light);

/// A disk with the table that its maps are read from (eta_table.h).
template <class T>
struct TabulatedDiskOf : DiskConstantsOf<T> {
  const float* coefficients;  // resolution² of them, for T = double too
  std::size_t resolution;
};
using TabulatedDisk = TabulatedDiskOf<float>;

/// Lengths are in units of its longer semi-axis.
template <class T>
struct EllipseConstantsOf {
  T center[3];      // world units
  T axes_hi[3][3];  // rows along the longer and the shorter semi-axis, unit vector / its length, and the unit normal /
  T axes_lo[3][3];  // the longer's length, rounded to T and what the rounding left
  T axes[3][3];     // the unit vectors, for the way back to world space
  T spans[2][3];    // semi_axis_u and semi_axis_v, for places
  T inverse_spans[2][3];           // the same divided by their squared lengths
  T ratio, ratio2, inverse_ratio;  // r, the shorter semi-axis over the longer; r², 1/r
  T flattening, flattening2;       // 1 − r² and its square
  T area;
  T radius;  // the longer semi-axis, world units
  T inverse_radius;
  bool swapped;  // semi_axis_v is the longer one
};
using EllipseConstants = EllipseConstantsOf<float>;

template <class T>
EllipseConstantsOf<T> constants_of(const Ellipse& light);

/// Of its edges the longer one counts as it is, the other without what it has along the longer: an edge that rounding
/// has turned a little moves the light by that share of its shorter side.
template <class T>
struct RectangleConstantsOf {
  T corner[3];      // world units
  T axes_hi[3][3];  // unit vectors along edge_u, edge_v and edge_u × edge_v, rounded to T …
  T axes_lo[3][3];  // … and what the rounding left
  T length_hi[2];   // of the edges, world units …
  T length_lo[2];   // … and what the rounding left
  T inverse_length[2];
  T unit;  // the power of two next below the longer edge: what area sampling measures in, so as not to overflow
  T inverse_unit;
  T edges[2][3];   // in units
  T inverse_area;  // in units
};
using RectangleConstants = RectangleConstantsOf<float>;

template <class T>
RectangleConstantsOf<T> constants_of(const Rectangle& light);

/// Its plane's axes: x along a → b, y towards c, z the
/// normal. Lengths are in units of `unit`, a power of two near the longest side. Side i lies opposite vertex i and runs
/// counterclockwise. What has a _lo is rounded to T, and that is what the rounding left.
template <class T>
struct TriangleConstantsOf {
  T vertex[3];      // a, world units
  T axes_hi[3][3];  // unit vectors / unit
  T axes_lo[3][3];
  T axes[3][3];                    // the unit vectors, for the way back to world space
  T side_hi[3][2], side_lo[3][2];  // (x, y)
  T length[3];                     // of the sides
  T doubled_area, inverse_area;
  T edges[2][3];  // b − a and c − a along the world's axes, in units
  T unit, inverse_unit;
};
using TriangleConstants = TriangleConstantsOf<float>;

template <class T>
TriangleConstantsOf<T> constants_of(const Triangle& light);

/// Twice the area over the square of the longest side: the triangle's height on that side, in its lengths. 0 where all
/// vertices are one.
double thinness(const Triangle& light);

/// The constants of a light that passes `check`; throws std::invalid_argument otherwise.
DiskConstants ready(const Disk& light);
EllipseConstants ready(const Ellipse& light);
RectangleConstants ready(const Rectangle& light);
TriangleConstants ready(const Triangle& light);

}  // namespace hatbox
