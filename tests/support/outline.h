// Where a light lies and what its rim is, whatever its kind: enough to integrate over it without any of its maps.
#pragma once

#include "reference/vector.h"

#include <hatbox/hatbox.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace hatbox::test {

/// The place (s, t) is origin + s·along_s + t·along_t. A round light is the unit disk of places, and has no corners.
struct Outline {
  reference::Vector<double> origin{}, along_s{}, along_t{};
  std::vector<std::array<double, 2>> corners;

  reference::Vector<double> at(double s, double t) const { return origin + s * along_s + t * along_t; }
  std::array<double, 2> middle() const;

  /// Whether it is that of no one light.
  bool is_nowhere() const { return along_s.x == 0 && along_s.y == 0 && along_s.z == 0; }

  /// How far a place lies outside of the light, in the place's own units; negative inside.
  double beyond(double s, double t) const;

  /// The way from the place (s, t) inside to the rim, in the direction (cos, sin) of places.
  double to_rim(const std::array<double, 2>& from, double angle) const;
};

inline Outline outline_of(const Disk& light) {
  const Axes a = axes(light);
  using reference::convert;
  return {convert<double>(light.center), convert<double>(a.u), convert<double>(a.v), {}};
}
inline Outline outline_of(const Ellipse& light) {
  using reference::convert;
  return {convert<double>(light.center), convert<double>(light.semi_axis_u), convert<double>(light.semi_axis_v), {}};
}
inline Outline outline_of(const Rectangle& light) {
  using reference::convert;
  return {convert<double>(light.corner),
          convert<double>(light.edge_u),
          convert<double>(light.edge_v),
          {{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
}
inline Outline outline_of(const Triangle& light) {
  using reference::convert;
  const auto a = convert<double>(light.a);
  return {a, convert<double>(light.b) - a, convert<double>(light.c) - a, {{0, 0}, {1, 0}, {0, 1}}};
}

inline std::array<double, 2> Outline::middle() const {
  std::array<double, 2> sum{0, 0};
  for (const auto& corner : corners) {
    sum[0] += corner[0] / static_cast<double>(corners.size());
    sum[1] += corner[1] / static_cast<double>(corners.size());
  }
  return sum;
}

inline double Outline::beyond(double s, double t) const {
  if (corners.empty()) return std::hypot(s, t) - 1;
  double farthest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto &p = corners[i], &q = corners[(i + 1) % corners.size()];
    farthest = std::max(farthest, (q[1] - p[1]) * (s - p[0]) + (p[0] - q[0]) * (t - p[1]));
  }
  return farthest;
}

inline double Outline::to_rim(const std::array<double, 2>& from, double angle) const {
  const double c = std::cos(angle), s = std::sin(angle);
  if (corners.empty()) {
    const double b = from[0] * c + from[1] * s, rest = 1 - from[0] * from[0] - from[1] * from[1];
    return rest / (b + std::sqrt(b * b + rest));
  }
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto &p = corners[i], &q = corners[(i + 1) % corners.size()];
    const double nx = q[1] - p[1], ny = p[0] - q[0];  // outwards, the corners being in mathematical order
    const double approach = nx * c + ny * s;
    if (approach > 0) nearest = std::min(nearest, (nx * (p[0] - from[0]) + ny * (p[1] - from[1])) / approach);
  }
  return nearest;
}

}  // namespace hatbox::test
