// The ellipses that the tests run on, in the poses and among the points of workloads.h.
#pragma once

#include "support/workloads.h"

#include <hatbox/ellipse.h>

#include <array>

namespace hatbox::test {

inline constexpr std::array all_ellipse_maps{EllipseMap::area, EllipseMap::ld_radial, EllipseMap::radial};

inline const char* name(EllipseMap map) {
  constexpr std::array names{"area", "ld_radial", "radial"};
  return names[static_cast<std::size_t>(map)];
}

/// What semi_axis_v is of semi_axis_u, which one is the longer included: the longer one is as long as the disk's
/// radius.
inline constexpr std::array ellipse_aspects{1.0, 0.5, 10.0, 0.01};

/// The disk in the pose, its axes shortened.
inline Ellipse ellipse_in(Pose pose, double aspect) {
  const Disk disk = disk_in(pose);
  const double radius = disk.radius, u = aspect > 1 ? 1 / aspect : 1, v = aspect > 1 ? 1 : aspect;
  const auto axis = [&](double x, double y) {
    const auto turned_axis = radius * turned(pose, {x, y, 0});
    return Vec3{static_cast<float>(turned_axis.x), static_cast<float>(turned_axis.y),
                static_cast<float>(turned_axis.z)};
  };
  return {disk.center, axis(u, 0), axis(0, v)};
}

inline Ellipse scaled(const Ellipse& light, float scale) {
  const auto times = [scale](const Vec3& v) { return Vec3{scale * v.x, scale * v.y, scale * v.z}; };
  return {times(light.center), times(light.semi_axis_u), times(light.semi_axis_v)};
}

}  // namespace hatbox::test
