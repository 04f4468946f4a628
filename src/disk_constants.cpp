#include "light_constants.h"

#include "light_frame.h"

#include <cmath>

namespace hatbox {
namespace {

struct Frame {
  Double3 u, v, n;
};

/// A right-handed frame about n, without branches that would make it jump (Duff et al. 2017, "Building an Orthonormal
/// Basis, Revisited"). For +z it is x, y, z.
Frame frame_of(Double3 n) {
  const double sign = std::copysign(1.0, n.z);
  const double a = -1.0 / (sign + n.z);
  const double b = n.x * n.y * a;
  return {{1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
}

}  // namespace

template <class T>
DiskConstantsOf<T> constants_of(const Disk& light) {
  const double nx = light.normal.x, ny = light.normal.y, nz = light.normal.z;
  const double length = std::sqrt(nx * nx + ny * ny + nz * nz);
  const double to_unit = 1.0 / length, to_radii = 1.0 / double{light.radius};
  const Frame frame = frame_of({nx * to_unit, ny * to_unit, nz * to_unit});

  DiskConstantsOf<T> constants = {};
  set_center(constants, light.center);
  set_axis(constants, 0, frame.u, to_radii);
  set_axis(constants, 1, frame.v, to_radii);
  set_axis(constants, 2, frame.n, to_radii);
  constants.radius = light.radius;
  constants.inverse_radius = static_cast<T>(to_radii);
  return constants;
}

template DiskConstantsOf<float> constants_of(const Disk& light);
template DiskConstantsOf<double> constants_of(const Disk& light);

}  // namespace hatbox
