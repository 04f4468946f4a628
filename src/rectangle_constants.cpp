#include "light_constants.h"

#include "light_frame.h"

#include <cmath>

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
  const Double3 axes[3] = {edges[0].unit, edges[1].unit, normal};
  const double unit = std::exp2(std::ilogb(std::fmax(edges[0].length, edges[1].length)));

  RectangleConstantsOf<T> constants = {};
  constants.corner[0] = light.corner.x;
  constants.corner[1] = light.corner.y;
  constants.corner[2] = light.corner.z;
  for (int row = 0; row < 3; ++row) {
    const double axis[3] = {axes[row].x, axes[row].y, axes[row].z};
    for (int i = 0; i < 3; ++i) {
      split(axis[i], constants.axes_hi[row][i], constants.axes_lo[row][i]);
      if (row < 2) constants.edges[row][i] = static_cast<T>(edges[row].length / unit * axis[i]);
    }
  }
  for (int i = 0; i < 2; ++i) {
    split(edges[i].length, constants.length_hi[i], constants.length_lo[i]);
    constants.inverse_length[i] = static_cast<T>(1 / edges[i].length);
  }
  constants.unit = static_cast<T>(unit);
  constants.inverse_unit = static_cast<T>(1 / unit);
  constants.inverse_area = static_cast<T>(unit / edges[0].length * (unit / edges[1].length));
  return constants;
}

template RectangleConstantsOf<float> constants_of(const Rectangle& light);
template RectangleConstantsOf<double> constants_of(const Rectangle& light);

}  // namespace hatbox
