// What is kept of a triangle; see light_rows.h.
#pragma once

#include <hatbox/lights.h>

namespace hatbox {

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

/// Of a light that passes `check`; throws std::invalid_argument otherwise.
TriangleConstants ready(const Triangle& light);

}  // namespace hatbox
