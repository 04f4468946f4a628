// A row of the table is the exact map of one ellipse. The inverse of a uniform angle solves the autonomous equation
//   dη/dθ = c (1 + h(η)),  c = (2/π) ∫ dη/(1 + h) over the quarter turn
// (Guillén et al. 2017, eq. 16-21 in the angle η), so no integral is inverted: Runge-Kutta's steps lead through it.
// Then the row's B-spline is made to pass through the result.
#include "eta_rows.h"

#include "schedule.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace hatbox {
namespace {

constexpr double pi = std::numbers::pi;

struct Ellipse {
  double cos_beta, k;  // k' = cos α/cos β

  double cos_alpha() const { return cos_beta * k; }
  double amplitude() const { return (cos_beta - cos_alpha()) / (2 + cos_alpha() + cos_beta); }
  double sigma_squared() const {
    const double sum = cos_alpha() + cos_beta;
    return (1 - k) / (1 + k) * (2 - sum) / (2 + sum);
  }
  double one_plus_height(double eta) const {
    const double cos = std::cos(eta);
    return 1 + cos_beta * std::sqrt(1 - (1 - k * k) * cos * cos);
  }
};

// Of all ellipses with one σ the row is that of cos β = k'^¼. Of the curves tried (k'^p with p from ¼ to 4, and cos β
// fixed) this is the one nearest to W1 and W2 in the density's variation. It ends where cos β is 0 and nothing is left
// to be told of D, hence the last row's k'.
Ellipse ellipse_of_row(double sigma) {
  constexpr double last_k = 1e-4;
  const auto on_curve = [](double k) { return Ellipse{std::sqrt(std::sqrt(k)), k}; };
  double low = last_k, high = 1;
  for (int i = 0; i < 50; ++i) {
    const double middle = (low + high) / 2;
    (on_curve(middle).sigma_squared() > sigma * sigma ? low : high) = middle;
  }
  return on_curve((low + high) / 2);
}

/// θ ↦ η − θ of an ellipse, for θ in the first quarter turn: by Runge-Kutta's fourth-order steps, between which it is
/// the cubic of their values and slopes.
class Inverse {
 public:
  explicit Inverse(const Ellipse& ellipse) : ellipse_(ellipse), c_(normalization(ellipse)) {
    for (std::size_t i = 0; i < steps; ++i) {
      const double theta = static_cast<double>(i) * h, y = shift_[i];
      const double k1 = slope_[i] = slope(theta + y);
      const double k2 = slope(theta + h / 2 + y + h / 2 * k1);
      const double k3 = slope(theta + h / 2 + y + h / 2 * k2);
      const double k4 = slope(theta + h + y + h * k3);
      shift_[i + 1] = y + h / 6 * (k1 + 2 * (k2 + k3) + k4);
    }
    slope_[steps] = slope(pi / 2);
  }

  double operator()(double theta) const {
    const double position = theta / h;
    const std::size_t i = std::min(static_cast<std::size_t>(position), steps - 1);
    const double t = position - static_cast<double>(i), rest = 1 - t;
    return rest * rest * (shift_[i] * (1 + 2 * t) + h * t * slope_[i]) +
           t * t * (shift_[i + 1] * (1 + 2 * rest) - h * rest * slope_[i + 1]);
  }

  /// Of η − θ, at the ends.
  double first_slope() const { return slope_[0]; }
  double last_slope() const { return slope_[steps]; }

 private:
  static constexpr std::size_t steps = 64;
  static constexpr double h = pi / 2 / steps;

  static double normalization(const Ellipse& ellipse) {
    double sum = 0;
    for (std::size_t i = 0; i < steps; ++i) sum += 1 / ellipse.one_plus_height((static_cast<double>(i) + 0.5) * h);
    return sum / steps;
  }

  double slope(double eta) const { return c_ * ellipse_.one_plus_height(eta) - 1; }

  Ellipse ellipse_;
  double c_;
  std::array<double, steps + 1> shift_{}, slope_{};
};

/// Where in a row D is taken, the middles of the cells of x = cos 2θ, from the last one to the first.
struct Place {
  double theta, sin_2theta;
};

std::vector<Place> places_in_row(std::size_t cells) {
  std::vector<Place> places(cells);
  for (std::size_t i = 0; i < cells; ++i) {
    const double two_theta = std::acos(1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(cells));
    places[i] = {two_theta / 2, std::sin(two_theta)};
  }
  return places;
}

/// D at x = −1, in the middles of the row's cells, and at x = 1.
std::vector<double> values_of_row(const Ellipse& ellipse, const std::vector<Place>& places) {
  const std::size_t cells = places.size();
  std::vector<double> values(cells + 2);
  const Inverse inverse(ellipse);
  const double scale = 1 / ellipse.amplitude();
  values[0] = 1 - scale * inverse.last_slope();
  for (std::size_t i = 0; i < cells; ++i) {
    values[cells - i] = 1 + 2 * scale * inverse(places[i].theta) / places[i].sin_2theta;
  }
  values[cells + 1] = 1 + scale * inverse.first_slope();
  return values;
}

/// The quadratic B-spline through the values of a row: (c[i−1] + 6c[i] + c[i+1])/8 in the middles of the cells and
/// (c[i] + c[i+1])/2 at both ends. Eliminated once for all rows, to c[i] + upper[i] c[i+1] = right-hand side.
class Spline {
 public:
  explicit Spline(std::size_t coefficients) : upper_(coefficients - 1) {
    upper_[0] = 1;
    for (std::size_t i = 1; i < upper_.size(); ++i) upper_[i] = 1 / (6 - upper_[i - 1]);
  }

  /// From values to coefficients, in place.
  void solve(std::vector<double>& c) const {
    const std::size_t last = upper_.size();
    c[0] *= 2;
    for (std::size_t i = 1; i < last; ++i) c[i] = (8 * c[i] - c[i - 1]) * upper_[i];
    c[last] = (2 * c[last] - c[last - 1]) / (1 - upper_[last - 1]);
    for (std::size_t i = last; i > 0; --i) c[i - 1] -= upper_[i - 1] * c[i];
  }

 private:
  std::vector<double> upper_;
};

void fill_row(float* row, double sigma, const std::vector<Place>& places, const Spline& spline) {
  std::vector<double> c = values_of_row(ellipse_of_row(sigma), places);
  spline.solve(c);
  std::transform(c.begin(), c.end(), row, [](double value) { return static_cast<float>(value); });
}

}  // namespace

std::shared_ptr<const float[]> make_eta_rows(std::size_t resolution) {
  const auto rows = std::make_shared<float[]>(resolution * resolution);  // zeros, as D is where σ is 0
  const std::vector<Place> places = places_in_row(resolution - 2);
  const Spline spline(resolution);
  for_each_in_parallel(1, resolution, [&](std::size_t row) {
    const double sigma = static_cast<double>(row) / static_cast<double>(resolution - 1);
    fill_row(rows.get() + row * resolution, sigma, places, spline);
  });
  return rows;
}

}  // namespace hatbox
