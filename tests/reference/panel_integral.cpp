#include "reference/panel_integral.h"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace hatbox::reference {
namespace {

constexpr double half_pi = std::numbers::pi / 2;

// Exact to the last digits here: the panels keep the integrand's singularities at least one panel away.
template <class Function>
double integrate(const Function& function, double from, double to) {
  return to > from ? boost::math::quadrature::gauss<double, 15>::integrate(function, from, to) : 0;
}

/// The panel that holds the value, given the panels' ends.
std::size_t panel_of(const std::vector<double>& ends, double value) {
  return static_cast<std::size_t>(std::upper_bound(ends.begin() + 1, ends.end() - 1, value) - ends.begin() - 1);
}

}  // namespace

PanelIntegral::PanelIntegral(std::function<double(double)> density, double width)
    : density_(std::move(density)), ends_{0}, sums_{0} {
  for (double end = width; ends_.back() < half_pi; end *= 2) {
    const double to = end > 0.75 * half_pi ? half_pi : end;
    sums_.push_back(sums_.back() + integrate(density_, ends_.back(), to));
    ends_.push_back(to);
  }
}

double PanelIntegral::share(double x) const {
  const std::size_t i = panel_of(ends_, x);
  return (sums_[i] + integrate(density_, ends_[i], x)) / whole();
}

/// Newton's method, which bisects where a step would leave the bracket.
double PanelIntegral::inverse(double share, int& iterations) const {
  const double target = share * whole();
  const std::size_t i = panel_of(sums_, target);
  const double rest = target - sums_[i];
  double low = ends_[i], high = ends_[i + 1];
  double x = low + rest / density_(low);
  for (int step = 0; step < 60; ++step, ++iterations) {
    if (!(x >= low && x <= high)) x = (low + high) / 2;
    const double before = x;
    const double residual = integrate(density_, ends_[i], x) - rest;
    (residual > 0 ? high : low) = x;
    x -= residual / density_(x);
    if (std::abs(x - before) <= 1e-14 * (ends_[i + 1] + before)) break;
  }
  return std::clamp(x, ends_[i], ends_[i + 1]);
}

}  // namespace hatbox::reference
