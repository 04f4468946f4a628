// A triangle from a point, in double: plain vector geometry, and the kernels' own text instantiated in double, which
// triangle_accuracy_test.cpp holds against golden values first. Needs HATBOX_ISA, as the kernels do.
#pragma once

#include "triangle_area_map.h"
#include "triangle_map.h"

#include "reference/vector.h"
#include "support/triangle_lights.h"
#include "triangle_constants.h"

#include <algorithm>
#include <array>

namespace hatbox::test {

namespace kernels = hatbox::HATBOX_ISA;

struct TriangleFrom {
  using Vector = reference::Vector<double>;

  TriangleFrom(const Triangle& light, const Vec3& from)
      : point(reference::convert<double>(from)),
        vertices{reference::convert<double>(light.a) - point, reference::convert<double>(light.b) - point,
                 reference::convert<double>(light.c) - point},
        sides{angle_between(vertices[1], vertices[2]), angle_between(vertices[2], vertices[0]),
              angle_between(vertices[0], vertices[1])} {}

  /// From the point to a place on the light.
  Vector to(double s, double t) const {
    return vertices[0] + s * (vertices[1] - vertices[0]) + t * (vertices[2] - vertices[0]);
  }

  double diameter() const { return std::max({sides[0], sides[1], sides[2]}); }

  /// Whether float may take another side for the smallest one than double does, and so another (u, v) for a direction.
  bool ambiguous() const {
    auto sorted = sides;
    std::sort(sorted.begin(), sorted.end());
    return sorted[1] < sorted[0] * (1 + 1e-5);
  }

  /// Unit vector at right angles to side i and the point, inwards.
  Vector inwards(std::size_t i) const {
    const Vector n = normalize(cross(vertices[(i + 1) % 3], vertices[(i + 2) % 3]));
    return dot(n, vertices[i]) < 0 ? -1.0 * n : n;
  }

  /// By van Oosterom and Strackee 1983; right to 1e-9 where the triangle is no smaller than W1 has it.
  double solid_angle() const {
    const Vector a = normalize(vertices[0]), b = normalize(vertices[1]), c = normalize(vertices[2]);
    return 2 * std::atan2(std::abs(dot(a, cross(b, c))), 1 + dot(a, b) + dot(b, c) + dot(c, a));
  }

  Vector point;
  std::array<Vector, 3> vertices;  // from the point
  std::array<double, 3> sides;     // angles
};

inline reference::Vector<double> direction_of(const kernels::LightSample<double>& sample) {
  return {sample.direction[0], sample.direction[1], sample.direction[2]};
}

/// Calls visit(map) with the map of a triangle from a point, in double.
template <class Visit>
auto with_triangle_map(TriangleMap map, const Triangle& light, const Vec3& p, const Visit& visit) {
  const kernels::TriangleLight<double> known(constants_of<double>(light));
  if (map == TriangleMap::area) return visit(kernels::TriangleArea<double>(known, p.x, p.y, p.z));
  return visit(kernels::TriangleSpherical<double>(known, p.x, p.y, p.z));
}

}  // namespace hatbox::test
