// The triangles of the tests, and their maps by name, to loop over and to print.
#pragma once

#include "support/workloads.h"

#include <hatbox/triangle.h>

#include <array>
#include <string>
#include <vector>

namespace hatbox::test {

inline constexpr std::array all_triangle_maps{TriangleMap::area, TriangleMap::spherical};

inline const char* name(TriangleMap map) {
  constexpr std::array names{"area", "spherical"};
  return names[static_cast<std::size_t>(map)];
}

/// A triangle given in the plane of the unit disk, moved as the disk is moved into the pose.
inline Triangle triangle_in(Pose pose, const std::array<std::array<double, 2>, 3>& vertices) {
  const auto vertex = [&](std::size_t i) { return moved(pose, {vertices[i][0], vertices[i][1], 0}); };
  return {vertex(0), vertex(1), vertex(2)};
}

/// Legs of length 1 from a corner where the disk has its centre: points that lie on the disk's axes do so on its sides.
inline Triangle cornered_triangle_in(Pose pose) { return triangle_in(pose, {{{0, 0}, {1, 0}, {0, 1}}}); }

struct NamedTriangle {
  std::string name;
  Triangle light;
};

/// The points of workloads.h lie around all of them; lengths are in units of the longer leg, or the longest side.
inline std::vector<NamedTriangle> triangles_in(Pose pose) {
  return {{"right", triangle_in(pose, {{{-0.5, -0.25}, {0.5, -0.25}, {-0.5, 0.75}}})},
          {"sliver", triangle_in(pose, {{{-0.5, 0}, {0.5, 0}, {-0.5, 0.001}}})},
          {"obtuse", triangle_in(pose, {{{-0.5, 0}, {0.5, 0}, {0.1, 0.001}}})}};
}

}  // namespace hatbox::test
