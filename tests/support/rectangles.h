// The rectangles of the tests, in the poses of workloads.h, and their maps by name.
#pragma once

#include "support/workloads.h"

#include <hatbox/rectangle.h>

#include <array>
#include <cstddef>

namespace hatbox::test {

inline constexpr std::array all_rectangle_maps{RectangleMap::area, RectangleMap::spherical,
                                               RectangleMap::two_triangles};

inline const char* name(RectangleMap map) {
  constexpr std::array names{"area", "spherical", "two_triangles"};
  return names[static_cast<std::size_t>(map)];
}

/// A unit square, and slivers of 1000 to 1 along either axis.
enum class Shape { square, wide, tall };
inline constexpr std::array all_shapes{Shape::square, Shape::wide, Shape::tall};

inline const char* name(Shape shape) {
  constexpr std::array names{"square", "wide", "tall"};
  return names[static_cast<std::size_t>(shape)];
}

/// Centred where the disk of the pose is, its normal the disk's, its longer edge of the length of the disk's radius:
/// the points of the workloads lie around it as around the disk, in units of that edge.
Rectangle rectangle_in(Pose pose, Shape shape);

}  // namespace hatbox::test
