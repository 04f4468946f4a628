// A row of the table is the exact map of one ellipse. The inverse of a uniform angle solves the autonomous equation
//   dη/dθ = c (1 + h(η)),  c = (2/π) ∫ dη/(1 + h) over the quarter turn
// (Guillén et al. 2017, eq. 16-21 in the angle η), so no integral is inverted: Runge-Kutta's steps lead from one place
// of the row to the next. Then the row's B-spline is made to pass through them.
#include "eta_rows.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
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

/// θ ↦ η − θ of an ellipse, from θ = 0 onwards.
class Inverse {
 public:
  explicit Inverse(const Ellipse& ellipse) : ellipse_(ellipse) {
    constexpr int nodes = 256;
    double sum = 0;
    for (int i = 0; i < nodes; ++i) sum += 1 / ellipse.one_plus_height((i + 0.5) * (pi / 2 / nodes));
    c_ = sum / nodes;
  }

  /// dη/dθ − 1.
  double slope_less_one(double eta) const { return c_ * ellipse_.one_plus_height(eta) - 1; }

  double advance_to(double theta) {
    constexpr double longest_step = 0.02;
    const int steps = 1 + static_cast<int>((theta - theta_) / longest_step);
    const double h = (theta - theta_) / steps;
    for (int i = 0; i < steps; ++i, theta_ += h) {
      const double k1 = slope_less_one(theta_ + shift_);
      const double k2 = slope_less_one(theta_ + h / 2 + shift_ + h / 2 * k1);
      const double k3 = slope_less_one(theta_ + h / 2 + shift_ + h / 2 * k2);
      const double k4 = slope_less_one(theta_ + h + shift_ + h * k3);
      shift_ += h / 6 * (k1 + 2 * (k2 + k3) + k4);
    }
    return shift_;
  }

 private:
  Ellipse ellipse_;
  double c_;
  double theta_ = 0, shift_ = 0;
};

/// D at x = −1, at the middles of the row's cells, and at x = 1.
std::vector<double> values_of_row(const Ellipse& ellipse, std::size_t cells) {
  std::vector<double> values(cells + 2);
  Inverse inverse(ellipse);
  const double scale = 1 / ellipse.amplitude();
  values[0] = 1 - scale * inverse.slope_less_one(pi / 2);
  values[cells + 1] = 1 + scale * inverse.slope_less_one(0);
  for (std::size_t i = cells; i > 0; --i) {
    const double x = (2 * static_cast<double>(i) - 1) / static_cast<double>(cells) - 1;
    const double theta = std::acos(x) / 2;
    values[i] = 1 + scale * 2 * inverse.advance_to(theta) / std::sin(2 * theta);
  }
  return values;
}

/// The quadratic B-spline through the values: (c[i−1] + 6c[i] + c[i+1])/8 in the middles of the cells and
/// (c[i] + c[i+1])/2 at both ends, by elimination in place.
void solve_spline(std::vector<double>& c) {
  const std::size_t last = c.size() - 1;
  std::vector<double> next(c.size());  // of the eliminated equations c[i] + next[i] c[i+1] = c[i]'s right-hand side
  next[0] = 1;
  c[0] *= 2;
  for (std::size_t i = 1; i < last; ++i) {
    const double pivot = 6 - next[i - 1];
    next[i] = 1 / pivot;
    c[i] = (8 * c[i] - c[i - 1]) / pivot;
  }
  c[last] = (2 * c[last] - c[last - 1]) / (1 - next[last - 1]);
  for (std::size_t i = last; i > 0; --i) c[i - 1] -= next[i - 1] * c[i];
}

void fill_row(float* row, std::size_t resolution, double sigma) {
  std::vector<double> c = values_of_row(ellipse_of_row(sigma), resolution - 2);
  solve_spline(c);
  std::transform(c.begin(), c.end(), row, [](double value) { return static_cast<float>(value); });
}

}  // namespace

std::shared_ptr<const float[]> make_eta_rows(std::size_t resolution) {
  const auto rows = std::make_shared<float[]>(resolution * resolution);  // zeros, as D is where σ is 0
  tbb::this_task_arena::isolate([&] {
    tbb::parallel_for(std::size_t{1}, resolution, [&](std::size_t row) {
      const double sigma = static_cast<double>(row) / static_cast<double>(resolution - 1);
      fill_row(rows.get() + row * resolution, resolution, sigma);
    });
  });
  return rows;
}

}  // namespace hatbox
