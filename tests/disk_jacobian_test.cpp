// The pdf that `sample` returns is the true density of its map, shown on the kernel's own text, instantiated in double.
#define HATBOX_ISA in_double
#include "disk_maps.h"

#include "disk_constants.h"
#include "support/jacobian.h"
#include "support/statistics.h"
#include "support/workloads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace hatbox::test {
namespace {

/// Not over the middle slice of the parallel map either.
double step_off_middle(double u, double v) { return 0.2 * std::min({std::abs(u - 0.5), u, 1 - u, v, 1 - v}); }

template <template <class> class Map>
std::vector<double> jacobian_errors(Pose pose, double (*largest_step)(double, double) = jacobian_step,
                                    std::size_t points_each = 120) {
  constexpr int grid = 32;
  const in_double::DiskLight<double> light(constants_of<double>(disk_in(pose)));
  std::vector<double> errors;
  for (const Workload workload : {Workload::w1, Workload::w2, Workload::w3}) {
    const PointArrays points = make_points(workload, pose, points_each);
    for (std::size_t p = 0; p < points.size(); ++p) {
      const Map<double> map(light, points.x[p], points.y[p], points.z[p]);
      for (int i = 0; i < grid; ++i) {
        for (int j = 0; j < grid; ++j) {
          const double u = (i + 0.37) / grid, v = (j + 0.59) / grid;  // off the seams u = v and u = 1 − v
          errors.push_back(jacobian_error(map, u, v, largest_step(u, v), largest_step(u, v)));
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
  // Several evaluations a sample make it slow in double, hence fewer points.
  expect_honest(jacobian_errors<in_double::DiskParallel>(GetParam(), step_off_middle, 64));
}
TEST_P(DiskJacobianSlow, Radial) { expect_honest(jacobian_errors<in_double::DiskRadial>(GetParam())); }
/// Their density is 1/Ω, whatever Newton's two steps leave over.
void expect_nearly_honest(const std::vector<double>& errors) {
  report_quantiles("jacobian", errors);
  EXPECT_LE(quantile(errors, 0.999), 1e-5);
  EXPECT_LE(quantile(errors, 1), 2e-3);
}

TEST_P(DiskJacobianSlow, RadialCarlson) {
  expect_nearly_honest(jacobian_errors<in_double::DiskRadialCarlson>(GetParam(), jacobian_step, 64));
}
TEST_P(DiskJacobianSlow, ParallelCarlson) {
  expect_nearly_honest(jacobian_errors<in_double::DiskParallelCarlson>(GetParam(), step_off_middle, 64));
}

INSTANTIATE_TEST_SUITE_P(Pose, DiskJacobianSlow, testing::Values(Pose::canonical, Pose::general),
                         [](const auto& pose) { return std::string(name(pose.param)); });

}  // namespace
}  // namespace hatbox::test
