#include "reference/spherical_ellipse.h"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hatbox::reference {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double half_pi = pi / 2;

// Exact to the last digits here: the panels below keep the integrand's singularities at least one panel away.
using Rule = boost::math::quadrature::gauss<double, 15>;

template <class Function>
double integrate(const Function& function, double from, double to) {
  return to > from ? Rule::integrate(function, from, to) : 0;
}

}  // namespace

/// h has its branch points near η = ± i cos α / cos β, so the panels start that wide and double.
SphericalEllipse::SphericalEllipse(const SemiAxes& axes) : axes_(axes), ends_{0}, sums_{0} {
  const auto integrand = [this](double eta) { return density(eta); };
  for (double end = axes.cos_alpha / axes.cos_beta; ends_.back() < half_pi; end *= 2) {
    const double to = end > 0.75 * half_pi ? half_pi : end;
    sums_.push_back(sums_.back() + integrate(integrand, ends_.back(), to));
    ends_.push_back(to);
  }
}

double SphericalEllipse::rim_height(double eta) const {
  return std::hypot(axes_.cos_alpha * std::cos(eta), axes_.cos_beta * std::sin(eta));
}

double SphericalEllipse::first_quadrant_theta(double eta) const {
  const auto panel = std::upper_bound(ends_.begin() + 1, ends_.end() - 1, eta) - ends_.begin() - 1;
  const auto i = static_cast<std::size_t>(panel);
  const double rest = integrate([this](double x) { return density(x); }, ends_[i], eta);
  return half_pi * (sums_[i] + rest) / sums_.back();
}

double SphericalEllipse::first_quadrant_eta(double theta, int& iterations) const {
  const double target = theta / half_pi * sums_.back();
  const auto panel = std::upper_bound(sums_.begin() + 1, sums_.end() - 1, target) - sums_.begin() - 1;
  const auto i = static_cast<std::size_t>(panel);
  const double rest = target - sums_[i];
  double eta = ends_[i] + rest / density(ends_[i]);
  for (int step = 0; step < 20; ++step, ++iterations) {
    const double clamped = std::clamp(eta, ends_[i], ends_[i + 1]);
    const double residual = integrate([this](double x) { return density(x); }, ends_[i], clamped) - rest;
    eta = clamped - residual / density(clamped);
    if (std::abs(eta - clamped) <= 1e-14 * (ends_[i + 1] + clamped)) break;
  }
  return eta;
}

double SphericalEllipse::theta(double eta) const {
  const double turn = pi * std::nearbyint(eta / pi);
  const double rest = eta - turn;
  return turn + std::copysign(first_quadrant_theta(std::abs(rest)), rest);
}

double SphericalEllipse::eta(double theta, int& iterations) const {
  const double turn = pi * std::nearbyint(theta / pi);
  const double rest = theta - turn;
  return turn + std::copysign(first_quadrant_eta(std::abs(rest), iterations), rest);
}

}  // namespace hatbox::reference
