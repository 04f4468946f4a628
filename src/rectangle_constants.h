// A rectangle made ready for the kernels: its frame, worked out once a call in double. T is float; double for the tests
// that run the kernels' text in double.
#pragma once

#include <hatbox/lights.h>

namespace hatbox {

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

/// The light must be valid (see `check`). Of its edges the longer one counts as it is, the other without what it has
/// along the longer: an edge that rounding has turned a little moves the light by that share of its shorter side.
template <class T>
RectangleConstantsOf<T> rectangle_constants(const Rectangle& light);

}  // namespace hatbox
