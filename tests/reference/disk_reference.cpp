#include "reference/disk_reference.h"

#include "reference/square_maps.h"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_3.hpp>

#include <algorithm>
#include <limits>

namespace hatbox::reference {
namespace {

constexpr double half_pi = std::numbers::pi / 2;

using Policy = boost::math::policies::policy<boost::math::policies::promote_double<false>>;

/// Equation 23 for one quadrant: how far θ is from the x axis, in quarter turns, and the signs that unfold it again.
struct Folded {
  double fraction, sign_x, sign_y;
};

Folded fold(double theta) {
  const double turns = theta / half_pi;
  const double quadrant = std::floor(turns);
  const double rest = turns - quadrant;
  switch (static_cast<int>(quadrant) & 3) {
    case 0: return {rest, 1, 1};
    case 1: return {1 - rest, -1, 1};
    case 2: return {rest, -1, -1};
    default: return {1 - rest, 1, -1};
  }
}

/// A root by Newton's method, which bisects where a step would leave the bracket. `rounding` is that of the residual.
template <class Residual, class Slope>
double newton(const Residual& residual, const Slope& slope, double low, double high, double start, double rounding,
              int& iterations) {
  constexpr double step_tolerance = 1e-12;
  double x = start;
  for (iterations = 1; iterations < 100; ++iterations) {
    const double off = residual(x);
    (off > 0 ? high : low) = x;
    double next = x - off / slope(x);
    if (!(next >= low && next <= high)) next = (low + high) / 2;
    const bool done = std::abs(next - x) <= step_tolerance || std::abs(off) <= rounding;
    x = next;
    if (done) break;
  }
  return x;
}

}  // namespace

PaperDisk::PaperDisk(const DiskFrame<double>& frame, const Vec3& point) : view_(frame, point) {
  const double z = view_.height();
  const double r = view_.radius();
  const double yc = view_.offset();
  // Equation 3 and Figure 2: the rim points in the symmetry plane, on the sphere, and the middle between them.
  const double l0 = std::hypot(yc - r, z);
  const double l1 = std::hypot(yc + r, z);
  const double y0 = (yc - r) / l0, z0 = z / l0;
  const double y1 = (yc + r) / l1, z1 = z / l1;
  const double yh = (y0 + y1) / 2, zh = (z0 + z1) / 2;
  const double middle = std::hypot(yh, zh);
  center_y_ = yh / middle;
  center_z_ = zh / middle;
  // Equation 4, with half the chord through the reprojected centre.
  const double chord_y = z * yh / zh;
  const double chord_x = std::sqrt((r - (chord_y - yc)) * (r + (chord_y - yc)));
  a_ = chord_x / std::sqrt(chord_x * chord_x + chord_y * chord_y + z * z);
  b_ = std::min(std::hypot(y1 - y0, z1 - z0) / 2, a_);
  // Equations 19 and 20.
  const double a2 = a_ * a_, b2 = b_ * b_;
  n_ = (a2 - b2) / (a2 * (1 - b2));
  k_ = std::sqrt((a2 - b2) / (1 - b2));
  factor_ = b_ * (1 - a2) / (a_ * std::sqrt(1 - b2));
  tangent_ratio_ = a_ / b_ * std::sqrt((1 - b2) / (1 - a2));
  whole_ = half_pi - factor_ * boost::math::ellint_3(k_, n_, Policy());
  // Equations 10 and 12; (a_t² − b_t²)/(a_t² + 1) = (a² − b²)/(1 − b²).
  tan_b_ = b_ / std::sqrt(1 - b2);
  slice_k_ = k_;
}

double PaperDisk::rim_radius(double phi) const { return a_ * b_ / std::hypot(a_ * std::sin(phi), b_ * std::cos(phi)); }

double PaperDisk::quadrant_area(double phi) const {
  const double parametric = std::atan2(tangent_ratio_ * std::sin(phi), std::cos(phi));
  return phi - factor_ * boost::math::ellint_3(k_, n_, parametric, Policy());
}

double PaperDisk::slice_height(double phi) const {
  const double sin = std::sin(phi), p = 1 / (tan_b_ * tan_b_);
  return a_ * std::sqrt(std::max(0.0, 1 - (p + 1) * sin * sin) / (1 - (slice_k_ * slice_k_ * p + 1) * sin * sin));
}

/// Of the slices between 0 and φ_p, with c_t = a_t/√(1 + a_t²) = a.
double PaperDisk::slices_area(double phi) const {
  const double parametric = std::asin(std::min(1.0, std::tan(phi) / tan_b_));
  const double n = -tan_b_ * tan_b_;
  return 2 * a_ / tan_b_ *
         ((1 - n) * boost::math::ellint_3(slice_k_, n, parametric, Policy()) -
          boost::math::ellint_1(slice_k_, parametric, Policy()));
}

Vector<double> PaperDisk::from_ellipse(double x, double y, double z) const {
  return {x, y * center_z_ + z * center_y_, z * center_z_ - y * center_y_};
}

DiskSample PaperDisk::sample(DiskMap map, float u, float v) const {
  const double cu = clamp_variate(u), cv = clamp_variate(v);
  if (map == DiskMap::area) {
    const Polar p = concentric(cu, cv);
    const Vector<double> direction = view_.direction_to_place(p.r * std::cos(p.phi), p.r * std::sin(p.phi));
    return view_.sample(direction, view_.area_pdf(direction));
  }
  int iterations = 0;
  const Vector<double> point =
      is_parallel(map) ? parallel_point(cu, cv, iterations) : radial_point(map, cu, cv, iterations);
  DiskSample result = view_.sample(from_ellipse(point.x, point.y, point.z), 1 / solid_angle());
  result.iterations = iterations;
  return result;
}

constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();  // of the areas, absolute

/// Equation 21. The paper's own start (φ proportional to the target) needs many more steps for narrow ellipses than the
/// parametric angle does.
Vector<double> PaperDisk::radial_point(DiskMap map, double u, double v, int& iterations) const {
  const PolarArea target = map == DiskMap::ld_radial ? low_distortion(u, v) : radial(u, v);
  const Folded quadrant = fold(target.theta);
  const double angle = quadrant.fraction * half_pi;
  const double phi = newton([&](double x) { return quadrant_area(x) - quadrant.fraction * whole_; },
                            [&](double x) {
                              const double rim = rim_radius(x);
                              return 1 - std::sqrt((1 - rim) * (1 + rim));
                            },
                            0, half_pi, std::atan2(b_ * std::sin(angle), a_ * std::cos(angle)), rounding, iterations);
  // Equations 17, 22 and 15 (with x and z as math has it: the cylinder's axis is z). t = 0 is the centre, h = 1.
  const double rim = rim_radius(phi);
  const double h = 1 - target.t * (1 - std::sqrt((1 - rim) * (1 + rim)));
  const double rho = std::sqrt((1 - h) * (1 + h));
  return {quadrant.sign_x * rho * std::cos(phi), quadrant.sign_y * rho * std::sin(phi), h};
}

int PaperDisk::published_steps(float u) const {
  constexpr int most = 100;
  constexpr double tolerance = 1e-9;
  const double target = clamp_variate(u) * whole_;
  double phi = clamp_variate(u) * half_pi;
  for (int step = 1; step < most; ++step) {
    const double sin = std::sin(phi), cos = std::cos(phi);
    const double parametric_sin = std::sin(std::atan2(tangent_ratio_ * sin, cos));
    const double s2 = parametric_sin * parametric_sin;
    const double integrand = factor_ / ((1 - n_ * s2) * std::sqrt(1 - k_ * k_ * s2));
    const double parametric_slope = tangent_ratio_ / (cos + tangent_ratio_ * sin);  // right: cos² + (a_t/b_t)² sin²
    const double residual = quadrant_area(phi) - target;
    const double next = std::clamp(phi - residual / (1 - integrand * parametric_slope), 0.0, half_pi);
    if (std::abs(next - phi) < tolerance || std::abs(residual) < tolerance) return step;
    phi = next;
  }
  return most;
}

/// Equation 13, and 14 and 15 as printed.
Vector<double> PaperDisk::parallel_point(double u, double v, int& iterations) const {
  const double beta = std::asin(b_);
  const double share = std::abs(2 * u - 1);
  const double target = share * slices_area(beta);
  const double phi = newton([&](double x) { return slices_area(x) - target; },
                            [&](double x) { return 2 * slice_height(x); }, 0, beta, share * beta, rounding, iterations);
  const double h = (2 * v - 1) * slice_height(phi);
  const double rho = std::sqrt((1 - h) * (1 + h));
  return {h, std::copysign(rho * std::sin(phi), u - 0.5), rho * std::cos(phi)};
}

}  // namespace hatbox::reference
