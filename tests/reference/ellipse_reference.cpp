#include "reference/ellipse_reference.h"

#include "reference/square_maps.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hatbox::reference {
namespace {

using Real = long double;
using Vec = Vector<Real>;

struct Columns {
  Vec e1, e2, l;
};

/// Makes e1 and e2 perpendicular, turning them as little as need be.
void rotate(Vec& e1, Vec& e2) {
  const Real product = dot(e1, e2);
  if (product == 0) return;
  const Real tau = (dot(e2, e2) - dot(e1, e1)) / (2 * product);
  const Real t = std::copysign(1 / (std::abs(tau) + std::hypot(Real(1), tau)), tau);
  const Real c = 1 / std::hypot(Real(1), t), s = c * t;
  const Vec before = e1;
  e1 = c * before - s * e2;
  e2 = s * before + c * e2;
}

/// Makes e and l perpendicular by a hyperbolic rotation: l + e and l − e are stretched until they are of one length,
/// and the diagonals of a rhombus are perpendicular.
void rotate_hyperbolic(Vec& e, Vec& l) {
  const Vec plus = l + e, minus = l - e;
  const Real stretch = std::sqrt(length(minus) / length(plus));
  const Vec p = stretch * plus, m = (1 / stretch) * minus;
  l = Real(0.5) * (p + m);
  e = Real(0.5) * (p - m);
}

Real skew(const Vec& p, const Vec& q) { return std::abs(dot(p, q)) / (length(p) * length(q)); }

/// The section of the cone at right angles to its axis (Veselić 1993): semi-axes e1, e2 and centre l.
Columns orthogonal_section(Columns g) {
  for (int sweep = 0; sweep < 60; ++sweep) {
    rotate(g.e1, g.e2);
    rotate_hyperbolic(g.e1, g.l);
    rotate_hyperbolic(g.e2, g.l);
    if (std::max({skew(g.e1, g.e2), skew(g.e1, g.l), skew(g.e2, g.l)}) < 1e-18L) break;
  }
  return g;
}

}  // namespace

EtaEllipse::View EtaEllipse::view(const Ellipse& light, const Vec3& point) {
  Vec u = convert<Real>(light.semi_axis_u), v = convert<Real>(light.semi_axis_v);
  // As the library promises: a circle, if it is one but for the rounding of coordinates.
  if (std::abs(length(v) / length(u) - 1) <= 0x1p-22L) v = (length(u) / length(v)) * v;
  const bool swapped = length(v) > length(u);
  Vec& longer = swapped ? v : u;
  Vec& shorter = swapped ? u : v;
  shorter = length(shorter) * normalize(shorter - (dot(shorter, longer) / dot(longer, longer)) * longer);

  View result;
  result.to_center = convert<Real>(light.center) - convert<Real>(point);
  result.axis_u = u;
  result.axis_v = v;
  result.normal = normalize(cross(u, v));
  Columns section = orthogonal_section({longer, shorter, result.to_center});
  if (length(section.e2) > length(section.e1)) std::swap(section.e1, section.e2);
  const Real alpha = std::hypot(length(section.e1), length(section.l));
  const Real beta = std::hypot(length(section.e2), length(section.l));
  result.semi_axes = {.a = static_cast<double>(length(section.e1) / alpha),
                      .b = static_cast<double>(length(section.e2) / beta),
                      .cos_alpha = static_cast<double>(length(section.l) / alpha),
                      .cos_beta = static_cast<double>(length(section.l) / beta)};
  // x̂ to the left of l as seen in the axes (longer, shorter), ŷ along l.
  const Real l_longer = dot(result.to_center, longer) / length(longer);
  const Real l_shorter = dot(result.to_center, shorter) / length(shorter);
  const Vec left = (-l_shorter / length(longer)) * longer + (l_longer / length(shorter)) * shorter;
  const Vec forth = (l_longer / length(longer)) * longer + (l_shorter / length(shorter)) * shorter;
  result.x = std::copysign(1 / length(section.e1), dot(section.e1, left)) * section.e1;
  result.y = std::copysign(1 / length(section.e2), dot(section.e2, forth)) * section.e2;
  result.z = normalize(section.l);
  return result;
}

EtaEllipse::EtaEllipse(const Ellipse& light, const Vec3& point)
    : view_(view(light, point)), ellipse_(view_.semi_axes) {}

EtaEllipse::Real EtaEllipse::area_pdf(const Vec& unit) const {
  const Real height = std::abs(dot(view_.to_center, view_.normal)), cosine = std::abs(dot(unit, view_.normal));
  const Real distance = height / cosine;
  return distance * distance / (std::numbers::pi_v<Real> * length(cross(view_.axis_u, view_.axis_v)) * cosine);
}

DiskSample EtaEllipse::describe(const Vec& unit, Real pdf) const {
  const Real distance = dot(view_.to_center, view_.normal) / dot(unit, view_.normal);
  const Vec place = distance * unit - view_.to_center;
  return {.direction = convert<double>(unit),
          .distance = static_cast<double>(distance),
          .pdf = static_cast<double>(pdf),
          .s = static_cast<double>(dot(place, view_.axis_u) / dot(view_.axis_u, view_.axis_u)),
          .t = static_cast<double>(dot(place, view_.axis_v) / dot(view_.axis_v, view_.axis_v)),
          .cosine = static_cast<double>(-dot(unit, view_.normal))};
}

DiskSample EtaEllipse::at(const EllipsePlace& place) const {
  const SemiAxes& axes = ellipse_.axes();
  int iterations = 0;
  const double eta = ellipse_.eta(place.theta, iterations);
  const Real x = axes.a * std::cos(static_cast<Real>(eta)), y = axes.b * std::sin(static_cast<Real>(eta));
  const Real h = ellipse_.rim_height(eta), t = place.t;
  const Real z = 1 - t * (x * x + y * y) / (1 + h);
  const Real s = std::sqrt(t * (1 + z) / (1 + h));
  return describe(normalize((s * x) * view_.x + (s * y) * view_.y + z * view_.z), 1 / solid_angle());
}

DiskSample EtaEllipse::sample(EllipseMap map, float u, float v) const {
  const double cu = clamp_variate(u), cv = clamp_variate(v);
  if (map == EllipseMap::area) {
    const Polar p = concentric(cu, cv);
    const Real s = p.r * std::cos(p.phi), t = p.r * std::sin(p.phi);
    const Vec unit = normalize(view_.to_center + s * view_.axis_u + t * view_.axis_v);
    return describe(unit, area_pdf(unit));
  }
  const PolarArea place = map == EllipseMap::radial ? radial(cu, cv) : low_distortion(cu, cv);
  return at({place.theta, place.t});
}

EllipsePlace EtaEllipse::locate_unit(const Vec& unit) const {
  const SemiAxes& axes = ellipse_.axes();
  const Real x = dot(unit, view_.x) / axes.a, y = dot(unit, view_.y) / axes.b, z = dot(unit, view_.z);
  const auto eta = static_cast<double>(std::atan2(y, x));
  const Real t = (x * x + y * y) * (1 + ellipse_.rim_height(eta)) / (1 + z);
  return {ellipse_.theta(eta), static_cast<double>(t)};
}

EllipsePlace EtaEllipse::locate(const Vector<double>& direction) const {
  return locate_unit(normalize(convert<Real>(direction)));
}

EllipsePlace EtaEllipse::locate(double s, double t) const {
  return locate_unit(normalize(view_.to_center + Real(s) * view_.axis_u + Real(t) * view_.axis_v));
}

double EtaEllipse::pdf(EllipseMap map, const Vector<double>& direction) const {
  const Vec unit = normalize(convert<Real>(direction));
  if (locate(direction).t > 1 || !(dot(unit, view_.normal) * dot(view_.to_center, view_.normal) > 0)) return 0;
  return map == EllipseMap::area ? static_cast<double>(area_pdf(unit)) : 1 / solid_angle();
}

}  // namespace hatbox::reference
