// The pdf that `sample` returns for an ellipse is the true density of its map, shown on the kernel's own text,
// instantiated in double.
#define HATBOX_ISA in_double
#include "ellipse_maps.h"

#include "ellipse_constants.h"
#include "support/ellipses.h"
#include "support/jacobian.h"
#include "support/statistics.h"

#include <gtest/gtest.h>

#include <string>
#include <tuple>

namespace hatbox::test {
namespace {

/// |J·pdf − 1| from the places: the way to the solid angle from them is (area) cosine/distance². A double direction to
/// a far, narrow light has too few digits left for a derivative.
template <class Map>
double jacobian_error_of_places(const Map& map, double area, double u, double v, double largest_step) {
  const auto at = [&](double du, double dv) {
    const auto sample = map.sample(u + du, v + dv);
    return Direction{sample.place.s, sample.place.t, 0};
  };
  const Direction by_u = derivative([&](double d) { return at(d, 0); }, largest_step);
  const Direction by_v = derivative([&](double d) { return at(0, d); }, largest_step);
  const auto here = map.sample(u, v);
  const double per_steradian = area * std::abs(here.cosine) / (here.distance * here.distance);
  return std::abs(parallelogram(by_u, by_v) * per_steradian * here.pdf - 1);
}

using EllipseParam = std::tuple<Pose, double>;

class EllipseJacobianSlow : public testing::TestWithParam<EllipseParam> {
 protected:
  template <template <class> class Map>
  static void expect_honest() {
    const auto [pose, aspect] = GetParam();
    const Ellipse ellipse = ellipse_in(pose, aspect);
    const double area =
        length(cross(reference::convert<double>(ellipse.semi_axis_u), reference::convert<double>(ellipse.semi_axis_v)));
    const in_double::EllipseLight<double> light(constants_of<double>(ellipse));
    constexpr int grid = 20;
    std::vector<double> errors;
    for (const Workload workload : all_workloads) {
      const PointArrays points = make_points(workload, pose, 60);
      for (std::size_t p = 0; p < points.size(); ++p) {
        const Map<double> map(light, points.x[p], points.y[p], points.z[p]);
        for (int i = 0; i < grid; ++i) {
          for (int j = 0; j < grid; ++j) {
            const double u = (i + 0.37) / grid, v = (j + 0.59) / grid;  // off the seams u = v and u = 1 − v
            const double step = jacobian_step(u, v);
            errors.push_back(
                std::min(jacobian_error(map, u, v, step, step), jacobian_error_of_places(map, area, u, v, step)));
          }
        }
      }
    }
    report_quantiles("jacobian", errors);
    EXPECT_LE(quantile(errors, 0.999), 1e-6);
    EXPECT_LE(quantile(errors, 1), 1e-5);
  }
};

TEST_P(EllipseJacobianSlow, Area) { expect_honest<in_double::EllipseArea>(); }
TEST_P(EllipseJacobianSlow, LdRadial) { expect_honest<in_double::EllipseLdRadial>(); }
TEST_P(EllipseJacobianSlow, Radial) { expect_honest<in_double::EllipseRadial>(); }

std::string jacobian_test_name(const testing::TestParamInfo<EllipseParam>& info) {
  return std::string(name(std::get<Pose>(info.param))) + "_" +
         std::to_string(static_cast<int>(100 * std::get<double>(info.param)));
}

INSTANTIATE_TEST_SUITE_P(Every, EllipseJacobianSlow,
                         testing::Combine(testing::Values(Pose::canonical, Pose::general),
                                          testing::ValuesIn(ellipse_aspects)),
                         jacobian_test_name);

}  // namespace
}  // namespace hatbox::test
