// The pdf that `sample` returns is the true density of its map: the kernel's own text, instantiated in double, is
// differentiated numerically, and the solid angle it stretches du dv over must be du dv/pdf. The direction is taken
// from the place, which far from the light has digits that a direction has not.
#define HATBOX_ISA rectangle_in_double
#include "rectangle_area_map.h"
#include "rectangle_map.h"
#include "two_triangles_map.h"

#include "rectangle_constants.h"
#include "support/jacobian.h"
#include "support/rectangles.h"
#include "support/statistics.h"
#include "support/workloads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace hatbox::test {
namespace {

namespace kernels = rectangle_in_double;

/// Of the map at (u, v): |∂(s,t)/∂(u,v)|·|edges|·cosine/distance² is the solid angle it makes of a piece of the square.
template <class Map>
double jacobian_error(const Map& map, double area, double u, double v, double seam) {
  const double step_u = 0.25 * std::min({u, 1 - u, std::abs(u - seam)}), step_v = 0.25 * std::min(v, 1 - v);
  const auto place = [&](double du, double dv) {
    const auto sample = map.sample(u + du, v + dv);
    return Components<2>{sample.place.s, sample.place.t};
  };
  const double stretch = parallelogram(derivative([&](double d) { return place(d, 0); }, step_u),
                                       derivative([&](double d) { return place(0, d); }, step_v));
  const auto here = map.sample(u, v);
  return std::abs(stretch * area * std::abs(here.cosine) / (here.distance * here.distance) * here.pdf - 1);
}

/// The u at which two_triangles goes from one triangle to the other: that map must not be differentiated across it.
double seam_from(const kernels::RectangleLight<double>& light, const Vec3& p) {
  const kernels::RectangleHalves<double> halves(light, p.x, p.y, p.z);
  const double first = kernels::SphericalTriangle<double>(halves.first).solid_angle();
  const double second = kernels::SphericalTriangle<double>(halves.second).solid_angle();
  return first / (first + second);
}

double no_seam(const kernels::RectangleLight<double>&, const Vec3&) { return 0; }

template <template <class> class Map, class Seam>
void expect_honest(Pose pose, Shape shape, const Seam& seam_of) {
  constexpr int grid = 32;
  const kernels::RectangleLight<double> light(constants_of<double>(rectangle_in(pose, shape)));
  const double area = light.length[0] * light.length[1];
  for (const Workload workload : all_workloads) {
    std::vector<double> errors;
    const PointArrays points = make_points(workload, pose, 40);
    for (std::size_t p = 0; p < points.size(); ++p) {
      const Map<double> map(light, points.x[p], points.y[p], points.z[p]);
      const double seam = seam_of(light, points[p]);
      for (int i = 0; i < grid * grid; ++i) {
        errors.push_back(jacobian_error(map, area, (i % grid + 0.5) / grid, (i / grid + 0.5) / grid, seam));
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

TEST_P(RectangleJacobianSlow, Area) { expect_honest<kernels::RectangleArea>(pose(), shape(), no_seam); }
TEST_P(RectangleJacobianSlow, Spherical) { expect_honest<kernels::RectangleSpherical>(pose(), shape(), no_seam); }
TEST_P(RectangleJacobianSlow, TwoTriangles) {
  expect_honest<kernels::RectangleTwoTriangles>(pose(), shape(), seam_from);
}

INSTANTIATE_TEST_SUITE_P(Every, RectangleJacobianSlow,
                         testing::Combine(testing::Values(Pose::canonical, Pose::general),
                                          testing::ValuesIn(all_shapes)),
                         [](const auto& given) {
                           return std::string(name(std::get<Pose>(given.param))) + "_" +
                                  name(std::get<Shape>(given.param));
                         });

}  // namespace
}  // namespace hatbox::test
