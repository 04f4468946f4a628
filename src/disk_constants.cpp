#include "disk_constants.h"

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
  const Frame frame = frame_of(divided({nx, ny, nz}, length));
  const double radius = light.radius, unit = power_of_two_below(radius);

  DiskConstantsOf<T> constants = {};
  set_vector(constants.center, in_double(light.center));
  set_vector(constants.axes[0], frame.u);
  set_vector(constants.axes[1], frame.v);
  set_split(constants.axes[2], constants.normal_lo, frame.n);
  constants.radius = light.radius;
  constants.inverse_radius = static_cast<T>(1 / radius);
  constants.inverse_unit = static_cast<T>(1 / unit);
  constants.per_unit = static_cast<T>(unit / radius);
  return constants;
}

template DiskConstantsOf<float> constants_of(const Disk& light);
template DiskConstantsOf<double> constants_of(const Disk& light);

}  // namespace hatbox
