#include "reference/spherical_ellipse.h"

#include <cmath>
#include <numbers>

namespace hatbox::reference {
namespace {

constexpr double pi = std::numbers::pi;

double height(const SemiAxes& axes, double eta) {
  return std::hypot(axes.cos_alpha * std::cos(eta), axes.cos_beta * std::sin(eta));
}

double slice_density(const SemiAxes& axes, double eta) {
  const double low = axes.cos_alpha * std::cos(eta), sin = std::sin(eta);
  return low * low / (height(axes, eta) * (low * low + sin * sin));
}

}  // namespace

/// h has its branch points near η = ± i cos α / cos β, the slices a pole near ± i cos α.
SphericalEllipse::SphericalEllipse(const SemiAxes& axes)
    : axes_(axes),
      sectors_([axes](double eta) { return 1 / (1 + height(axes, eta)); }, axes.cos_alpha / axes.cos_beta),
      slices_([axes](double eta) { return slice_density(axes, eta); }, axes.cos_alpha) {}

double SphericalEllipse::rim_height(double eta) const { return height(axes_, eta); }

double SphericalEllipse::theta(double eta) const {
  const double turn = pi * std::nearbyint(eta / pi);
  const double rest = eta - turn;
  return turn + std::copysign(pi / 2 * sectors_.share(std::abs(rest)), rest);
}

double SphericalEllipse::eta(double theta, int& iterations) const {
  const double turn = pi * std::nearbyint(theta / pi);
  const double rest = theta - turn;
  return turn + std::copysign(sectors_.inverse(std::abs(rest) / (pi / 2), iterations), rest);
}

double SphericalEllipse::slice_eta(double u, int& iterations) const {
  return std::copysign(slices_.inverse(std::abs(2 * u - 1), iterations), u - 0.5);
}

}  // namespace hatbox::reference
