// Is the pdf that a map's `sample` returns its true density? The map, which must be one in double, is differentiated
// numerically, and the solid angle it stretches du dv over must be du dv/pdf.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace hatbox::test {

/// What is differentiated: a direction, or a place on the light.
template <std::size_t N>
using Components = std::array<double, N>;
using Direction = Components<3>;

template <std::size_t N>
Components<N> operator-(Components<N> a, const Components<N>& b) {
  for (std::size_t i = 0; i < N; ++i) a[i] -= b[i];
  return a;
}

template <std::size_t N>
Components<N> operator*(double s, Components<N> a) {
  for (double& x : a) x *= s;
  return a;
}

/// Of the parallelogram that two derivatives span.
inline double parallelogram(const Components<2>& a, const Components<2>& b) {
  return std::abs(a[0] * b[1] - a[1] * b[0]);
}

inline double parallelogram(const Direction& a, const Direction& b) {
  const double x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2], z = a[0] * b[1] - a[1] * b[0];
  return std::sqrt(x * x + y * y + z * z);
}

/// Of their difference.
template <std::size_t N>
double largest_component(const Components<N>& a, const Components<N>& b) {
  double result = 0;
  for (const double x : a - b) result = std::max(result, std::abs(x));
  return result;
}

/// f'(0) by central differences, extrapolated to a step of 0 from ever smaller ones; of all the extrapolations the one
/// that agrees best with those it was made from (Ridders 1982). No one step would do: 1e-5 above the disk a direction
/// turns over within 1e-5 of the square, and far from it rounding asks for a step a thousand times that.
template <class F>
auto derivative(const F& f, double largest_step) {
  using Value = decltype(f(largest_step));
  constexpr std::size_t levels = 8;
  constexpr double ratio = 2.5;
  std::array<Value, levels> previous{}, row{};
  Value best{};
  double best_error = std::numeric_limits<double>::infinity();
  double h = largest_step;
  while (largest_component(f(h), f(-h)) > 0.05) h /= 2;  // the map bends on the scale of the directions it has swept
  for (std::size_t i = 0; i < levels && best_error > 1e-11 * largest_component(best, Value{}); ++i, h /= ratio) {
    row[0] = 1 / (2 * h) * (f(h) - f(-h));
    double factor = 1;
    for (std::size_t j = 1; j <= i; ++j) {
      factor *= ratio * ratio;
      row[j] = 1 / (factor - 1) * (factor * row[j - 1] - previous[j - 1]);
      const double error = std::max(largest_component(row[j], row[j - 1]), largest_component(row[j], previous[j - 1]));
      if (error < best_error) {
        best_error = error;
        best = row[j];
      }
    }
    previous = row;
  }
  return best;
}

/// |J·pdf − 1| at (u, v), from steps of at most so much.
template <class Map>
double jacobian_error(const Map& map, double u, double v, double step_u, double step_v) {
  const auto at = [&](double du, double dv) {
    const auto sample = map.sample(u + du, v + dv);
    return Direction{sample.direction[0], sample.direction[1], sample.direction[2]};
  };
  const Direction by_u = derivative([&](double d) { return at(d, 0); }, step_u);
  const Direction by_v = derivative([&](double d) { return at(0, d); }, step_v);
  return std::abs(parallelogram(by_u, by_v) * map.sample(u, v).pdf - 1);
}

/// How far a step may go: not over an edge of the square, nor over a seam or the centre of the concentric map.
inline double jacobian_step(double u, double v) {
  const double a = std::abs(2 * u - 1), b = std::abs(2 * v - 1);
  return 0.2 * std::min(std::abs(a - b), 1 - std::max(a, b));
}

}  // namespace hatbox::test
