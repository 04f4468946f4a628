#include "reference/rectangle_reference.h"

#include <algorithm>

namespace hatbox::reference {
namespace {

using Vec = Vector<Quad>;

Quad norm(const Vec& p) { return sqrt(dot(p, p)); }

Vec quad(const Vec3& p) { return {Quad(p.x), Quad(p.y), Quad(p.z)}; }

/// Of two edges that rounding has turned the longer stays; the other loses what it has along the longer.
struct Edges {
  explicit Edges(const Rectangle& light) : u(quad(light.edge_u)), v(quad(light.edge_v)) {
    Vec& longer = norm(u) >= norm(v) ? u : v;
    Vec& shorter = norm(u) >= norm(v) ? v : u;
    shorter = shorter - Quad(dot(shorter, longer) / dot(longer, longer)) * longer;
  }
  Vec u, v;
};

Vector<long double> direction_of(const Vec& p) {
  const Vec unit = Quad(1 / norm(p)) * p;
  return {static_cast<long double>(unit.x), static_cast<long double>(unit.y), static_cast<long double>(unit.z)};
}

}  // namespace

RectangleReference::RectangleReference(const Rectangle& light, const Vec3& point)
    : to_corner_(quad(light.corner) - quad(point)),
      quad_(quad(light.corner), Edges(light).u, Edges(light).v, quad(point)) {
  const Edges edges(light);
  length_[0] = norm(edges.u);
  length_[1] = norm(edges.v);
  axes_[0] = Quad(1 / length_[0]) * edges.u;
  axes_[1] = Quad(1 / length_[1]) * edges.v;
  axes_[2] = cross(axes_[0], axes_[1]);
}

RectangleSample RectangleReference::sample(float u, float v) const {
  const Vec at = quad_.local(Quad(u), Quad(v));
  const Quad height = dot(to_corner_, axes_[2]);
  const Vec world = at.x * axes_[0] + at.y * axes_[1] + height * axes_[2];
  return {direction_of(world), static_cast<long double>(Quad((at.x - quad_.x0) / length_[0])),
          static_cast<long double>(Quad((at.y - quad_.y0) / length_[1]))};
}

Vector<long double> RectangleReference::direction(long double s, long double t) const {
  return direction_of(to_corner_ + Quad(s) * (length_[0] * axes_[0]) + Quad(t) * (length_[1] * axes_[1]));
}

long double RectangleReference::diameter() const {
  const Vector<long double> corners[] = {direction(0, 0), direction(1, 0), direction(1, 1), direction(0, 1)};
  long double result = 0;
  for (const auto& p : corners) {
    for (const auto& q : corners) result = std::max(result, angle_between(p, q));
  }
  return result;
}

}  // namespace hatbox::reference
