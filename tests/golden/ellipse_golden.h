// The golden values that make_ellipse_golden.py wrote.
#pragma once

#include <hatbox/ellipse.h>

namespace hatbox::test {

struct GoldenEllipse {
  Vec3 point;
  Ellipse light;
  double solid_angle;
};

inline constexpr GoldenEllipse golden_ellipses[] = {
#include "golden/ellipse_solid_angle.inc"
};

}  // namespace hatbox::test
