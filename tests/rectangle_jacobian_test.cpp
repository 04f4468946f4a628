// The pdf that `sample` returns is the true density of its map: the kernel's own text, instantiated in double, is
// differentiated numerically, and the solid angle it stretches du dv over must be du dv/pdf. The direction is taken
// from the place, which far from the light has digits that a direction has not.
#define HATBOX_ISA rectangle_in_double
#include "maps.h"

#include "light_constants.h"
#include "support/rectangles.h"
#include "support/statistics.h"
#include "support/workloads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace hatbox::test {
namespace {

using rectangle_in_double::LightSample;
using Pair = std::array<double, 2>;

Pair operator-(const Pair& a, const Pair& b) { return {a[0] - b[0], a[1] - b[1]}; }
Pair operator*(double s, const Pair& a) { return {s * a[0], s * a[1]}; }
double largest(const Pair& a) { return std::max(std::abs(a[0]), std::abs(a[1])); }

/// f'(0) by central differences, extrapolated to a step of 0 from ever smaller ones; of all the extrapolations the one
/// that agrees best with those it was made from (Ridders 1982).
template <class F>
Pair derivative(const F& f, double largest_step) {
  constexpr std::size_t levels = 10;
  constexpr double ratio = 2;
  std::array<Pair, levels> previous{}, row{};
  Pair best{};
  double best_error = std::numeric_limits<double>::infinity();
  double h = largest_step;
  for (std::size_t i = 0; i < levels && best_error > 1e-11 * largest(best); ++i, h /= ratio) {
    row[0] = 1 / (2 * h) * (f(h) - f(-h));
    double factor = 1;
    for (std::size_t j = 1; j <= i; ++j) {
      factor *= ratio * ratio;
      row[j] = 1 / (factor - 1) * (factor * row[j - 1] - previous[j - 1]);
      const double error = std::max(largest(row[j] - row[j - 1]), largest(row[j] - previous[j - 1]));
      if (error < best_error) {
        best_error = error;
        best = row[j];
      }
    }
    previous = row;
  }
  return best;
}

/// Of the map at (u, v): |∂(s,t)/∂(u,v)|·|edges|·cosine/distance² is the solid angle it makes of a piece of the square.
template <class Map>
double jacobian_error(const Map& map, double area, double u, double v) {
  const double step_u = 0.25 * std::min(u, 1 - u), step_v = 0.25 * std::min(v, 1 - v);
  const auto place = [&](double du, double dv) {
    const LightSample<double> sample = map.sample(u + du, v + dv);
    return Pair{sample.place.s, sample.place.t};
  };
  const Pair by_u = derivative([&](double d) { return place(d, 0); }, step_u);
  const Pair by_v = derivative([&](double d) { return place(0, d); }, step_v);
  const LightSample<double> here = map.sample(u, v);
  const double stretch = std::abs(by_u[0] * by_v[1] - by_u[1] * by_v[0]);
  return std::abs(stretch * area * std::abs(here.cosine) / (here.distance * here.distance) * here.pdf - 1);
}

template <template <class> class Map>
void expect_honest(Pose pose, Shape shape) {
  constexpr int grid = 32;
  const auto light = constants_of<double>(rectangle_in(pose, shape));
  const double area = light.length_hi[0] * light.length_hi[1];
  for (const Workload workload : all_workloads) {
    std::vector<double> errors;
    const PointArrays points = make_points(workload, pose, 40);
    for (std::size_t p = 0; p < points.size(); ++p) {
      const Map<double> map(light, points.x[p], points.y[p], points.z[p]);
      for (int i = 0; i < grid * grid; ++i) {
        errors.push_back(jacobian_error(map, area, (i % grid + 0.5) / grid, (i / grid + 0.5) / grid));
      }
    }
    report_quantiles(std::string("jacobian_") + name(workload) + "_" + name(shape), errors);
    EXPECT_LE(quantile(errors, 1), 1e-7);
  }
}

class RectangleJacobianSlow : public testing::TestWithParam<std::tuple<Pose, Shape>> {
 protected:
  Pose pose() const { return std::get<Pose>(GetParam()); }
  Shape shape() const { return std::get<Shape>(GetParam()); }
};

TEST_P(RectangleJacobianSlow, Area) { expect_honest<rectangle_in_double::RectangleArea>(pose(), shape()); }
TEST_P(RectangleJacobianSlow, Spherical) { expect_honest<rectangle_in_double::RectangleSpherical>(pose(), shape()); }

INSTANTIATE_TEST_SUITE_P(Every, RectangleJacobianSlow,
                         testing::Combine(testing::Values(Pose::canonical, Pose::general),
                                          testing::ValuesIn(all_shapes)),
                         [](const auto& given) {
                           return std::string(name(std::get<Pose>(given.param))) + "_" +
                                  name(std::get<Shape>(given.param));
                         });

}  // namespace
}  // namespace hatbox::test
