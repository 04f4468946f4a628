// The pdf that `sample` returns is the true density of its map: the kernel's own text, instantiated in double, is
// differentiated numerically, and the solid angle it stretches du dv over must be du dv/pdf. By the direction, and
// where the light is far, by the place, whose derivatives do not drown in the rounding of a direction.
#define HATBOX_ISA in_double
#include "support/triangle_reference.h"

#include "support/jacobian.h"
#include "support/statistics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hatbox::test {
namespace {

using reference::Vector;

/// The area that du dv is stretched over, by a function of (u, v).
template <class F>
double stretch(const F& f, double u, double v, double step) {
  return parallelogram(derivative([&](double d) { return f(u + d, v); }, step),
                       derivative([&](double d) { return f(u, v + d); }, step));
}

template <class Map>
double error_by_direction(const Map& map, double u, double v, double step) {
  const auto at = [&](double x, double y) {
    const auto sample = map.sample(x, y);
    return Direction{sample.direction[0], sample.direction[1], sample.direction[2]};
  };
  return std::abs(stretch(at, u, v, step) * map.sample(u, v).pdf - 1);
}

template <class Map>
double error_by_place(const Map& map, const TriangleFrom& seen, double u, double v, double step) {
  const auto at = [&](double x, double y) {
    const auto place = map.sample(x, y).place;
    return Components<2>{place.s, place.t};
  };
  const auto sample = map.sample(u, v);
  const Vector<double> p = seen.to(sample.place.s, sample.place.t);
  const auto& corner = seen.vertices;
  const double volume = std::abs(dot(p, cross(corner[1] - corner[0], corner[2] - corner[0])));
  const double solid_angle = stretch(at, u, v, step) * volume / std::pow(length(p), 3);
  return std::abs(solid_angle * sample.pdf - 1);
}

std::vector<double> jacobian_errors(const NamedTriangle& triangle, TriangleMap map, Workload workload, Pose pose) {
  const Triangle& light = triangle.light;
  const bool narrow = workload != Workload::w1 || triangle.name != "right";
  constexpr int grid = 32;
  const PointArrays points = make_points(workload, pose, 16);
  std::vector<double> errors;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const TriangleFrom seen(light, points[p]);
    with_triangle_map(map, light, points[p], [&](const auto& m) {
      for (int i = 0; i < grid * grid; ++i) {
        const double u = (i % grid + 0.37) / grid, v = (i / grid + 0.59) / grid;  // off the seam u = v of `area`
        const double step = 0.2 * std::min({u, 1 - u, v, 1 - v, std::abs(u - v)});
        errors.push_back(narrow ? error_by_place(m, seen, u, v, step) : error_by_direction(m, u, v, step));
        const auto sample = m.sample(u, v);
        EXPECT_LE(angle_between(direction_of(sample), seen.to(sample.place.s, sample.place.t)), 1e-10);
      }
    });
  }
  return errors;
}

class TriangleJacobianSlow : public testing::TestWithParam<Pose> {};

TEST_P(TriangleJacobianSlow, PdfIsTheDensity) {
  for (const NamedTriangle& triangle : triangles_in(GetParam())) {
    for (const TriangleMap map : all_triangle_maps) {
      for (const Workload workload : all_workloads) {
        const std::string what = "jacobian_" + triangle.name + "_" + name(map) + "_" + name(workload);
        const auto errors = jacobian_errors(triangle, map, workload, GetParam());
        report_quantiles(what, errors);
        EXPECT_LE(quantile(errors, 1), 1e-7) << what;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Pose, TriangleJacobianSlow, testing::Values(Pose::canonical, Pose::general),
                         [](const auto& pose) { return std::string(name(pose.param)); });

}  // namespace
}  // namespace hatbox::test
