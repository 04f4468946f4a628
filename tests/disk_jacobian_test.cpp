// The pdf that `sample` returns is the true density of its map: the kernel's own text, instantiated in double, is
// differentiated numerically, and the solid angle it stretches du dv over must be du dv/pdf.
#define HATBOX_ISA in_double
#include "maps.h"

#include "disk_constants.h"
#include "support/statistics.h"
#include "support/workloads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace hatbox::test {
namespace {

using in_double::LightSample;
using Direction = std::array<double, 3>;

Direction operator-(const Direction& a, const Direction& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Direction operator*(double s, const Direction& a) { return {s * a[0], s * a[1], s * a[2]}; }

double area(const Direction& a, const Direction& b) {
  const double x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2], z = a[0] * b[1] - a[1] * b[0];
  return std::sqrt(x * x + y * y + z * z);
}

double distance(const Direction& a, const Direction& b) {
  const Direction d = a - b;
  return std::max({std::abs(d[0]), std::abs(d[1]), std::abs(d[2])});
}

/// f'(0) by central differences, extrapolated to a step of 0 from ever smaller ones; of all the extrapolations the one
/// that agrees best with those it was made from (Ridders 1982). No one step would do: 1e-5 above the disk a direction
/// turns over within 1e-5 of the square, and far from it rounding asks for a step a thousand times that.
template <class F>
Direction derivative(const F& f, double largest_step) {
  constexpr std::size_t levels = 8;
  constexpr double ratio = 2.5;
  std::array<Direction, levels> previous{}, row{};
  Direction best{};
  double best_error = std::numeric_limits<double>::infinity();
  double h = largest_step;
  while (distance(f(h), f(-h)) > 0.05) h /= 2;  // the map bends on the scale of the directions it has swept
  for (std::size_t i = 0; i < levels && best_error > 1e-11 * distance(best, {}); ++i, h /= ratio) {
    row[0] = 1 / (2 * h) * (f(h) - f(-h));
    double factor = 1;
    for (std::size_t j = 1; j <= i; ++j) {
      factor *= ratio * ratio;
      row[j] = 1 / (factor - 1) * (factor * row[j - 1] - previous[j - 1]);
      const double error = std::max(distance(row[j], row[j - 1]), distance(row[j], previous[j - 1]));
      if (error < best_error) {
        best_error = error;
        best = row[j];
      }
    }
    previous = row;
  }
  return best;
}

template <class Map>
double jacobian_error(const Map& map, double u, double v, double h) {
  const auto at = [&](double du, double dv) {
    const LightSample<double> sample = map.sample(u + du, v + dv);
    return Direction{sample.direction[0], sample.direction[1], sample.direction[2]};
  };
  const Direction by_u = derivative([&](double d) { return at(d, 0); }, h);
  const Direction by_v = derivative([&](double d) { return at(0, d); }, h);
  return std::abs(area(by_u, by_v) * map.sample(u, v).pdf - 1);
}

/// How far a step may go: not over an edge of the square, nor over a seam or the centre of the concentric map.
double step(double u, double v) {
  const double a = std::abs(2 * u - 1), b = std::abs(2 * v - 1);
  return 0.2 * std::min(std::abs(a - b), 1 - std::max(a, b));
}

/// Nor over an edge of the square or the middle slice of the parallel map.
double step_off_middle(double u, double v) { return 0.2 * std::min({std::abs(u - 0.5), u, 1 - u, v, 1 - v}); }

template <template <class> class Map>
std::vector<double> jacobian_errors(Pose pose, double (*largest_step)(double, double) = step,
                                    std::size_t points_each = 334) {
  constexpr int grid = 32;
  const DiskConstantsOf<double> light = disk_constants<double>(disk_in(pose));
  std::vector<double> errors;
  for (const Workload workload : {Workload::w1, Workload::w2, Workload::w3}) {
    const PointArrays points = make_points(workload, pose, points_each);
    for (std::size_t p = 0; p < points.size(); ++p) {
      const Map<double> map(light, points.x[p], points.y[p], points.z[p]);
      for (int i = 0; i < grid; ++i) {
        for (int j = 0; j < grid; ++j) {
          const double u = (i + 0.37) / grid, v = (j + 0.59) / grid;  // off the seams u = v and u = 1 − v
          errors.push_back(jacobian_error(map, u, v, largest_step(u, v)));
        }
      }
    }
  }
  return errors;
}

class DiskJacobianSlow : public testing::TestWithParam<Pose> {};

void expect_honest(const std::vector<double>& errors) {
  report_quantiles("jacobian", errors);
  EXPECT_LE(quantile(errors, 0.999), 1e-6);
  EXPECT_LE(quantile(errors, 1), 1e-5);
}

TEST_P(DiskJacobianSlow, Area) { expect_honest(jacobian_errors<in_double::DiskArea>(GetParam())); }
TEST_P(DiskJacobianSlow, LdRadial) { expect_honest(jacobian_errors<in_double::DiskLdRadial>(GetParam())); }
TEST_P(DiskJacobianSlow, Parallel) {
  // Five evaluations a sample make it slow in double, hence fewer points.
  expect_honest(jacobian_errors<in_double::DiskParallel>(GetParam(), step_off_middle, 64));
}
TEST_P(DiskJacobianSlow, Radial) { expect_honest(jacobian_errors<in_double::DiskRadial>(GetParam())); }

INSTANTIATE_TEST_SUITE_P(Pose, DiskJacobianSlow, testing::Values(Pose::canonical, Pose::general),
                         [](const auto& pose) { return std::string(name(pose.param)); });

}  // namespace
}  // namespace hatbox::test
