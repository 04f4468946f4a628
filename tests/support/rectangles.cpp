#include "support/rectangles.h"

namespace hatbox::test {
namespace {

Vec3 to_float(const reference::Vector<double>& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

}  // namespace

Rectangle rectangle_in(Pose pose, Shape shape) {
  const double u = shape == Shape::tall ? 1e-3 : 1, v = shape == Shape::wide ? 1e-3 : 1;
  const double unit = disk_in(pose).radius;
  return {moved(pose, {-u / 2, -v / 2, 0}), to_float(unit * turned(pose, {u, 0, 0})),
          to_float(unit * turned(pose, {0, v, 0}))};
}

}  // namespace hatbox::test
