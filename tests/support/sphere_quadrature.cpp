#include "support/sphere_quadrature.h"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <numbers>
#include <utility>

namespace hatbox::test {
namespace {

using reference::Vector;

struct Node {
  double x, weight;
};

/// Gauss's rule of 24 nodes on [from, to].
std::vector<Node> gauss(double from, double to) {
  using Rule = boost::math::quadrature::gauss<double, 24>;
  const double middle = (from + to) / 2, half = (to - from) / 2;
  std::vector<Node> nodes;
  for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
    for (const double side : {-1.0, 1.0}) {
      nodes.push_back({middle + side * half * Rule::abscissa()[i], half * Rule::weights()[i]});
    }
  }
  return nodes;
}

/// Round the whole turn: trapezoids about a round light, which converge as fast as Gauss's rule; else from corner to
/// corner.
std::vector<Node> turn_about(const Outline& light, const std::array<double, 2>& middle) {
  constexpr double turn = 2 * std::numbers::pi;
  std::vector<Node> nodes;
  if (light.corners.empty()) {
    constexpr int steps = 256;
    for (int i = 0; i < steps; ++i) nodes.push_back({turn * i / steps, turn / steps});
    return nodes;
  }
  std::vector<double> angles;
  for (const auto& corner : light.corners) {
    angles.push_back(std::atan2(corner[1] - middle[1], corner[0] - middle[0]));
  }
  std::ranges::sort(angles);
  angles.push_back(angles.front() + turn);
  for (std::size_t i = 0; i + 1 < angles.size(); ++i) {
    for (const Node& node : gauss(angles[i], angles[i + 1])) nodes.push_back(node);
  }
  return nodes;
}

/// Next to a large light its solid angle is about the point's foot.
std::array<double, 2> pole_of(const Outline& light, const Vector<double>& to_point) {
  const double ss = dot(light.along_s, light.along_s), tt = dot(light.along_t, light.along_t);
  const double st = dot(light.along_s, light.along_t), determinant = ss * tt - st * st;
  const double ps = dot(to_point, light.along_s), pt = dot(to_point, light.along_t);
  const std::array<double, 2> foot{(tt * ps - st * pt) / determinant, (ss * pt - st * ps) / determinant};
  double room = 1 - std::hypot(foot[0], foot[1]);
  if (!light.corners.empty()) {
    room = std::min(foot[0], foot[1]);
    room = std::min(room, light.corners.size() == 3 ? 1 - foot[0] - foot[1] : std::min(1 - foot[0], 1 - foot[1]));
  }
  return room > 0.05 ? foot : light.middle();
}

}  // namespace

void DirectionArrays::push_back(const Vector<double>& direction) {
  const Vector<double> unit = normalize(direction);
  x.push_back(static_cast<float>(unit.x));
  y.push_back(static_cast<float>(unit.y));
  z.push_back(static_cast<float>(unit.z));
}

SphereQuadrature::SphereQuadrature(const Outline& light, const Vec3& point) {
  const auto eye = reference::convert<double>(point);
  const std::array<double, 2> pole = pole_of(light, eye - light.origin);
  const Vector<double> normal = cross(light.along_s, light.along_t);
  const double height = length(light.at(pole[0], pole[1]) - eye);
  const double size = std::max(length(light.along_s), length(light.along_t));
  for (const auto& corner : light.corners) rim.push_back(normalize(light.at(corner[0], corner[1]) - eye));
  for (const Node& turned : turn_about(light, pole)) {
    const double c = std::cos(turned.x), sine = std::sin(turned.x), rim_at = light.to_rim(pole, turned.x);
    const auto way_to = [&](double r) { return light.at(pole[0] + r * c, pole[1] + r * sine) - eye; };
    for (const Node& node :
         gauss(0, std::asinh(rim_at * size / height))) {  // r = height/size sinh w: dense at the pole
      const double r = height / size * std::sinh(node.x), stretch = height / size * std::cosh(node.x);
      const Vector<double> way = way_to(r);
      const double distance = length(way);
      hits.push_back(way);
      s.push_back(static_cast<float>(pole[0] + r * c));
      t.push_back(static_cast<float>(pole[1] + r * sine));
      const double per_area = std::abs(dot(way, normal)) / (distance * distance * distance);
      weights.push_back(turned.weight * node.weight * stretch * r * per_area);
      misses.push_back(-1.0 * way);
    }
    if (light.corners.empty()) rim.push_back(normalize(way_to(rim_at)));
    for (const double beyond : {1.003, 1.03, 1.3, 3.0, 30.0, 1e4}) {
      misses.push_back(way_to(beyond * rim_at));
      misses.push_back(-1.0 * way_to(beyond * rim_at));
    }
    misses.push_back(c * light.along_s + sine * light.along_t);
  }
}

}  // namespace hatbox::test
