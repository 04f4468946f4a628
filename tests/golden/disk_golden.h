// The golden values that make_disk_golden.py wrote.
#pragma once

#include "reference/vector.h"

#include <hatbox/disk.h>

namespace hatbox::test {

struct GoldenSolidAngle {
  Vec3 point;
  Disk light;
  double solid_angle;
  double conditioning;  // Σ |∂Ω/∂xᵢ| ulp(xᵢ) over the coordinates of point, centre and normal
};

struct GoldenDirection {
  DiskMap map;
  Vec3 point;
  Disk light;
  float u, v;
  reference::Vector<double> direction;
};

inline constexpr GoldenSolidAngle golden_solid_angles[] = {
#include "golden/disk_solid_angle.inc"
};

inline constexpr GoldenDirection golden_directions[] = {
#include "golden/disk_direction.inc"
};

}  // namespace hatbox::test
