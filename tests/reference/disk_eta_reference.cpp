#include "reference/disk_eta_reference.h"

#include "reference/square_maps.h"

#include <cmath>

namespace hatbox::reference {
namespace {

using Real = long double;

/// p + q and p − q, the second from their product where it would cancel.
struct SumAndDifference {
  Real sum, difference;
};

SumAndDifference without_cancellation(Real p, Real q, Real product) {
  if (q >= 0) return {p + q, product / (p + q)};
  return {product / (p - q), p - q};
}

struct RimDistances {
  Real nearest, farthest;
};

RimDistances rim_distances(const DiskView<Real>& view) {
  return {std::hypot(view.offset() - view.radius(), view.height()),
          std::hypot(view.offset() + view.radius(), view.height())};
}

/// With L = l₀l₁ and s = d² + h² − r²: sin α = 2r/(l₀+l₁), cos²α = 2(L+s)/(l₀+l₁)², sin²β = (L−s)/2L,
/// cos²β = (L+s)/2L, and (L−s)(L+s) = 4r²h².
SemiAxes cone_of(const DiskView<Real>& view) {
  const Real r = view.radius(), d = view.offset(), h = view.height();
  const auto [nearest, farthest] = rim_distances(view);
  const Real l = nearest * farthest;
  const Real mean = nearest + farthest;
  const auto [plus, minus] = without_cancellation(l, (d - r) * (d + r) + h * h, 4 * r * r * h * h);
  return {.a = static_cast<double>(2 * r / mean),
          .b = static_cast<double>(std::sqrt(minus / (2 * l))),
          .cos_alpha = static_cast<double>(std::sqrt(2 * plus) / mean),
          .cos_beta = static_cast<double>(std::sqrt(plus / (2 * l)))};
}

}  // namespace

/// The centre of the ellipse bisects the directions to the nearest and farthest rim: the half-angle formula with
/// X = d² − h² − r² in place of s.
EtaDisk::EtaDisk(const DiskFrame<Real>& frame, const Vec3& point) : view_(frame, point), ellipse_(cone_of(view_)) {
  const Real r = view_.radius(), d = view_.offset(), h = view_.height();
  const auto [nearest, farthest] = rim_distances(view_);
  const Real l = nearest * farthest;
  const auto [plus, minus] = without_cancellation(l, (d - r) * (d + r) - h * h, 4 * d * d * h * h);
  center_y_ = std::sqrt(plus / (2 * l));
  center_z_ = std::sqrt(minus / (2 * l));
}

/// q = (a S cos η, b S sin η, z) with z = 1 − tρ²/(1+h), S² = t(1+z)/(1+h): no special case at the centre.
EtaDisk::Local EtaDisk::from_ellipse(const EllipsePlace& place, int& iterations) const {
  const SemiAxes& axes = ellipse_.axes();
  const Real t = place.t;
  const double eta = ellipse_.eta(place.theta, iterations);
  const Real x = axes.a * std::cos(static_cast<Real>(eta));
  const Real y = axes.b * std::sin(static_cast<Real>(eta));
  const Real h = ellipse_.rim_height(eta);
  const Real z = 1 - t * (x * x + y * y) / (1 + h);
  const Real s = std::sqrt(t * (1 + z) / (1 + h));
  return from_frame(s * x, s * y, z);
}

/// Equations 14 and 15, with φ_p and h_p those of the rim point η.
EtaDisk::Local EtaDisk::from_slice(double u, double v, int& iterations) const {
  const SemiAxes& axes = ellipse_.axes();
  const double eta = ellipse_.slice_eta(u, iterations);
  const Real phi = std::atan2(axes.b * std::sin(static_cast<Real>(eta)), static_cast<Real>(ellipse_.rim_height(eta)));
  const Real h = (2 * static_cast<Real>(v) - 1) * axes.a * std::cos(static_cast<Real>(eta));
  // 1 − a² cancels for cones that are nearly full.
  const Real x = h / axes.a;
  const Real rho = std::hypot(static_cast<Real>(axes.cos_alpha), axes.a * std::sqrt((1 - x) * (1 + x)));
  return from_frame(h, rho * std::sin(phi), rho * std::cos(phi));
}

EtaDisk::Local EtaDisk::from_frame(Real x, Real y, Real z) const {
  return {x, y * center_z_ + z * center_y_, z * center_z_ - y * center_y_};
}

EllipsePlace EtaDisk::locate_local(const Local& direction) const {
  const SemiAxes& axes = ellipse_.axes();
  const Real z = direction.y * center_y_ + direction.z * center_z_;
  const Real x = direction.x / axes.a;
  const Real y = (direction.y * center_z_ - direction.z * center_y_) / axes.b;
  const auto eta = static_cast<double>(std::atan2(y, x));
  const Real t = (x * x + y * y) * (1 + ellipse_.rim_height(eta)) / (1 + z);
  return {ellipse_.theta(eta), static_cast<double>(t)};
}

DiskSample EtaDisk::sample(DiskMap map, float u, float v) const {
  const double cu = clamp_variate(u), cv = clamp_variate(v);
  if (map == DiskMap::area) {
    const Polar p = concentric(cu, cv);
    const Local direction = view_.direction_to_place(p.r * std::cos(p.phi), p.r * std::sin(p.phi));
    return view_.sample(direction, view_.area_pdf(direction));
  }
  if (is_parallel(map)) {
    int iterations = 0;
    DiskSample result = view_.sample(from_slice(cu, cv, iterations), 1 / solid_angle());
    result.iterations = iterations;
    return result;
  }
  const PolarArea place = map == DiskMap::ld_radial ? low_distortion(cu, cv) : radial(cu, cv);
  return at({place.theta, place.t});
}

DiskSample EtaDisk::at(const EllipsePlace& place) const {
  int iterations = 0;
  DiskSample result = view_.sample(from_ellipse(place, iterations), 1 / solid_angle());
  result.iterations = iterations;
  return result;
}

EllipsePlace EtaDisk::locate(const Vector<double>& direction) const {
  return locate_local(view_.to_local(normalize(convert<Real>(direction))));
}

EllipsePlace EtaDisk::locate(double s, double t) const { return locate_local(view_.direction_to_place(s, t)); }

double EtaDisk::pdf(DiskMap map, const Vector<double>& direction) const {
  const Local local = view_.to_local(normalize(convert<Real>(direction)));
  if (locate_local(local).t > 1 || !(local.z > 0)) return 0;
  return map == DiskMap::area ? static_cast<double>(view_.area_pdf(local)) : 1 / solid_angle();
}

}  // namespace hatbox::reference
