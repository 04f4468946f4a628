#include "medium.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wavefront {
namespace {

using Imath::V3d;

struct Range {
  double begin, end;
};

constexpr double infinity = std::numeric_limits<double>::infinity();

Range in_cube(const V3d& origin, const V3d& direction) {
  Range range{-infinity, infinity};
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] == 0) {
      if (std::abs(origin[axis]) >= 1) return {0, 0};
      continue;
    }
    const double a = (-1 - origin[axis]) / direction[axis], b = (1 - origin[axis]) / direction[axis];
    range = {std::max(range.begin, std::min(a, b)), std::min(range.end, std::max(a, b))};
  }
  return range;
}

Range in_ball(const V3d& origin, const V3d& direction) {
  const double a = direction.length2();
  const double middle = -origin.dot(direction) / a;
  const double reach = (1 - (origin + direction * middle).length2()) / a;
  return reach > 0 ? Range{middle - std::sqrt(reach), middle + std::sqrt(reach)} : Range{0, 0};
}

}  // namespace

Interval inside(const Medium& medium, const V3f& origin, const V3f& direction, float end) {
  if (medium.body) {
    const V3d from = V3d(origin) * medium.body->to_local;
    V3d along;
    medium.body->to_local.multDirMatrix(V3d(direction), along);
    const Range range = medium.body->ball ? in_ball(from, along) : in_cube(from, along);
    return {static_cast<float>(std::max(range.begin, 0.0)), std::min(end, static_cast<float>(range.end))};
  }
  // Nothing that float can tell comes through more than 104 mean free paths: e^-104 is the smallest number there is.
  return {0, std::min(end, 104 / lowest_extinction(medium))};
}

Rgb transmittance(const Medium& medium, float length) {
  const Rgb depth = (medium.sigma_s + medium.sigma_a) * length;
  if (depth.x == depth.y && depth.y == depth.z) return Rgb(std::exp(-depth.x));
  return {std::exp(-depth.x), std::exp(-depth.y), std::exp(-depth.z)};
}

Rgb transmittance(const std::optional<Medium>& medium, const V3f& origin, const V3f& direction, float distance) {
  if (!medium) return Rgb(1.0f);
  if (!medium->body) return transmittance(*medium, distance);
  const Interval part = inside(*medium, origin, direction, distance);
  return transmittance(*medium, std::max(part.end - part.begin, 0.0f));
}

float lowest_extinction(const Medium& medium) {
  const Rgb extinction = medium.sigma_s + medium.sigma_a;
  return std::min({extinction.x, extinction.y, extinction.z});
}

}  // namespace wavefront
