// What is kept of a rectangle; see light_rows.h.
#pragma once

#include <hatbox/lights.h>

namespace hatbox {

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

/// Of a light that passes `check`; throws std::invalid_argument otherwise.
RectangleConstants ready(const Rectangle& light);

}  // namespace hatbox
