// The golden values that make_triangle_golden.py wrote.
#pragma once

#include "reference/vector.h"

#include <hatbox/lights.h>

namespace hatbox::test {

struct GoldenTriangleSolidAngle {
  Vec3 point;
  Triangle light;
  double solid_angle;
  double conditioning;  // Σ |∂Ω/∂xᵢ| ulp(xᵢ) over the coordinates of point and vertices
};

struct GoldenTriangleDirection {
  Vec3 point;
  Triangle light;
  float u, v;
  reference::Vector<double> direction;
  double s, t;
  double diameter;  // angular, of the light
};

inline constexpr GoldenTriangleSolidAngle golden_triangle_solid_angles[] = {
#include "golden/triangle_solid_angle.inc"
};

inline constexpr GoldenTriangleDirection golden_triangle_directions[] = {
#include "golden/triangle_direction.inc"
};

}  // namespace hatbox::test
