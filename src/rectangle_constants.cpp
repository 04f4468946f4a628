#include "rectangle_constants.h"

#include "light_frame.h"

namespace hatbox {
namespace {

/// `p` without what it has along the unit vector `axis`.
Double3 without(const Double3& p, const Double3& axis) {
  const double along = dot(p, axis);
  return {p.x - along * axis.x, p.y - along * axis.y, p.z - along * axis.z};
}

}  // namespace

template <class T>
RectangleConstantsOf<T> constants_of(const Rectangle& light) {
  const Double3 u = in_double(light.edge_u), v = in_double(light.edge_v);
  Extent edges[2] = {extent_of(u), extent_of(v)};
  if (edges[0].length >= edges[1].length) {
    edges[1] = extent_of(without(v, edges[0].unit));
  } else {
    edges[0] = extent_of(without(u, edges[1].unit));
  }
  const Double3 normal = cross(edges[0].unit, edges[1].unit);

  RectangleConstantsOf<T> constants = {};
  set_vector(constants.corner, in_double(light.corner));
  for (int i = 0; i < 2; ++i) {
    constants.length[i] = static_cast<T>(edges[i].length);
    const double stretch = constants.length[i] / edges[i].length;
    set_split(constants.axes_hi[i], constants.axes_lo[i], scaled(stretch, edges[i].unit));
  }
  set_split(constants.axes_hi[2], constants.axes_lo[2], normal);
  return constants;
}

template RectangleConstantsOf<float> constants_of(const Rectangle& light);
template RectangleConstantsOf<double> constants_of(const Rectangle& light);

}  // namespace hatbox
