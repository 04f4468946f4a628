#include "reference/irradiance.h"

#include "reference/disk_view.h"

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <numbers>

namespace hatbox::reference {
namespace {

using Rule = boost::math::quadrature::gauss_kronrod<double, 31>;
constexpr unsigned depth = 7;  // the relative tolerance cannot be met far away, where the contour's parts cancel
constexpr double tolerance = 1e-13;

/// E = ½ |∮ n·(r × dr) / r²| (Lambert 1760), for the rim to_center + cos φ u + sin φ v. Along a chord in the plane of
/// the horizon the integrand is the angle itself.
double irradiance(const Vector<double>& to_center, const Vector<double>& u, const Vector<double>& v,
                  const Vector<double>& patch_normal) {
  const auto rim = [&](double phi) { return to_center + std::cos(phi) * u + std::sin(phi) * v; };
  const auto integrand = [&](double phi) {
    const Vector<double> tangent = std::cos(phi) * v - std::sin(phi) * u;
    const Vector<double> r = rim(phi);
    return dot(patch_normal, cross(r, tangent)) / dot(r, r);
  };

  const double middle = std::atan2(dot(v, patch_normal), dot(u, patch_normal));
  const double swing = std::hypot(dot(u, patch_normal), dot(v, patch_normal));
  const double height = dot(to_center, patch_normal);
  if (height <= -swing) return 0;
  const bool clipped = height < swing;
  const double half = clipped ? std::acos(-height / swing) : std::numbers::pi;
  const double arc = Rule::integrate(integrand, middle - half, middle, depth, tolerance) +
                     Rule::integrate(integrand, middle, middle + half, depth, tolerance);
  if (!clipped) return std::abs(arc) / 2;
  const Vector<double> from = rim(middle + half), to = rim(middle - half);
  const double chord = std::copysign(angle_between(from, to), dot(patch_normal, cross(from, to)));
  return std::abs(arc + chord) / 2;
}

}  // namespace

double irradiance(const Disk& light, const Vec3& point, const Vector<double>& patch_normal) {
  const DiskFrame<double> frame(light);
  return irradiance(frame.center - convert<double>(point), frame.radius * frame.axis_u, frame.radius * frame.axis_v,
                    patch_normal);
}

double irradiance(const Ellipse& light, const Vec3& point, const Vector<double>& patch_normal) {
  return irradiance(convert<double>(light.center) - convert<double>(point), convert<double>(light.semi_axis_u),
                    convert<double>(light.semi_axis_v), patch_normal);
}

}  // namespace hatbox::reference
