#include "reference/paper_table.h"

#include "reference/square_maps.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hatbox::reference {
namespace {

constexpr double half_pi = std::numbers::pi / 2;
constexpr double tabulated_alpha = std::numbers::pi / 4;

/// Arvo 1995, "Stratified sampling of spherical triangles": B is the pole z, A and C lie at polar angle `leg`, at the
/// azimuths 0 and `apex`. So the first variate turns about the pole and the second leads away from it.
Vector<double> sample_triangle(double leg, double apex, double u, double v) {
  const double cos_c = std::cos(leg), sin_c = std::sin(leg);
  const Vector<double> A{sin_c, 0, cos_c}, C{sin_c * std::cos(apex), sin_c * std::sin(apex), cos_c};
  const double alpha = std::atan2(std::cos(apex / 2), cos_c * std::sin(apex / 2));  // Napier; the same at C
  const double tangent = std::tan(leg / 2) * std::tan(leg / 2);
  const double excess = 2 * std::atan2(tangent * std::sin(apex), 1 + tangent * std::cos(apex));
  const double s = std::sin(u * excess - alpha), t = std::cos(u * excess - alpha);
  const double p = t - std::cos(alpha), w = s + std::sin(alpha) * cos_c;
  const double cosine = ((w * t - p * s) * std::cos(alpha) - w) / ((w * s + p * t) * std::sin(alpha));
  const double q = std::clamp(cosine, -1.0, 1.0);
  const Vector<double> along = normalize(C - dot(C, A) * A);
  const Vector<double> end = q * A + std::sqrt(1 - q * q) * along;
  const double z = 1 - v * (1 - end.z);
  const double rho = std::sqrt((1 - z) * (1 + z)) / std::hypot(end.x, end.y);
  return {rho * end.x, rho * end.y, z};
}

Vector<double> turned(const Vector<double>& q, double angle) {
  const double cos = std::cos(angle), sin = std::sin(angle);
  return {cos * q.x - sin * q.y, sin * q.x + cos * q.y, q.z};
}

}  // namespace

PaperTable::PaperTable(std::size_t resolution) {
  const auto n = static_cast<double>(resolution);
  // The first row, of β = 0, would have no solid angle; half a row stands in for it.
  for (std::size_t i = 0; i < resolution; ++i) {
    rows_.push_back(std::vector<double>(resolution + 1));
    std::vector<double>& row = rows_.back();
    const double a = std::sin(tabulated_alpha);
    const double b = std::sin(tabulated_alpha * std::max(static_cast<double>(i), 0.5) / n);
    // Equation 17: dΩ/dφ = 1 − √(1 − sin² θ(φ)); integrated by Simpson's rule.
    const auto density = [&](double phi) {
      const double rim = a * b / std::hypot(a * std::sin(phi), b * std::cos(phi));
      return rim * rim / (1 + std::sqrt((1 - rim) * (1 + rim)));
    };
    const double width = half_pi / n;
    double before = density(0);
    for (std::size_t j = 0; j < resolution; ++j) {
      const double phi = width * static_cast<double>(j), after = density(phi + width);
      row[j + 1] = row[j] + before + 4 * density(phi + width / 2) + after;
      before = after;
    }
    for (double& share : row) share /= row.back();
  }
}

std::optional<DiskSample> PaperTable::sample(const PaperDisk& disk, float u, float v) const {
  const double n = static_cast<double>(rows_.size());
  const double ratio = std::asin(disk.sin_beta()) / std::asin(disk.sin_alpha());
  const std::vector<double>& row = rows_[std::min(static_cast<std::size_t>(ratio * n), rows_.size() - 1)];
  const double quarters = 4 * clamp_variate(u), quadrant = std::floor(quarters), share = quarters - quadrant;
  const auto next = std::upper_bound(row.begin() + 1, row.end() - 1, share);
  const double rest = (share - next[-1]) / (next[0] - next[-1]);
  const double width = half_pi / n, phi = width * static_cast<double>(next - row.begin() - 1);
  const double leg = std::asin(std::min(disk.rim_radius(phi), 1.0));
  Vector<double> q = turned(sample_triangle(leg, width, rest, clamp_variate(v)), phi);
  const auto quarter = static_cast<int>(quadrant);
  if (quarter == 1 || quarter == 2) q.x = -q.x;
  if (quarter >= 2) q.y = -q.y;
  const double x = q.x / disk.sin_alpha(), y = q.y / disk.sin_beta();
  if (x * x + y * y > 1) return {};
  return disk.at(q);
}

}  // namespace hatbox::reference
