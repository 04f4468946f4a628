// The area of slices and its inverse (slice_area.h), in double: against quadrature, and how fast the inverse converges.
#define HATBOX_ISA in_double
#include "slice_area.h"

#include "disk_cone.h"
#include "disk_constants.h"
#include "reference/spherical_ellipse.h"
#include "support/random.h"
#include "support/statistics.h"
#include "support/workloads.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace hatbox::test {
namespace {

using in_double::DiskCone;
using in_double::SliceArea;

std::vector<DiskCone<double>> cones(const in_double::DiskLight<double>& light, Workload workload, std::size_t n) {
  const PointArrays points = make_points(workload, Pose::canonical, n);
  std::vector<DiskCone<double>> result;
  for (std::size_t i = 0; i < n; ++i) result.emplace_back(light, points.x[i], points.y[i], points.z[i]);
  return result;
}

const in_double::DiskLight<double> unit_disk(constants_of<double>(disk_in(Pose::canonical)));

/// Also next to the end of the minor axis, where it must not cancel: 1e-6 is the third power of ζ.
TEST(SliceArea, IsTheReferences) {
  for (const DiskCone<double>& cone : cones(unit_disk, Workload::w1, 200)) {
    const SliceArea<double> area(cone);
    const double cos_alpha = std::sqrt(cone.k2) * cone.cos_beta;
    const reference::SphericalEllipse ellipse({cone.a, cone.b, cos_alpha, cone.cos_beta});
    for (const double u : {1e-6, 1e-4, 0.01, 0.1, 0.3, 0.45}) {
      int iterations = 0;
      const double eta = -ellipse.slice_eta(u, iterations);
      const double zeta = std::atan2(cos_alpha * std::cos(eta), std::sin(eta));
      EXPECT_NEAR(area.share(area.upto(zeta / (std::numbers::pi / 4))) / (2 * u), 1, 1e-5) << u;
    }
  }
}

/// A step off by `error` gives a density off by about as much, so three steps must leave less than rounding to float.
TEST(SliceArea, ThreeStepsInvert) {
  Random random(5);
  for (const Workload workload : all_workloads) {
    std::vector<std::vector<double>> errors(4);
    for (const DiskCone<double>& cone : cones(unit_disk, workload, 2000)) {
      const SliceArea<double> area(cone);
      const double share = random.uniform(1e-6, 1);
      auto bracket = area.first_guess(share);
      std::vector<double> guesses;
      for (int step = 0; step < 8; ++step, bracket = area.better_guess(bracket, share)) {
        guesses.push_back(bracket.guess);
      }
      for (std::size_t i = 0; i < errors.size(); ++i) errors[i].push_back(std::abs(guesses[i] / guesses.back() - 1));
    }
    for (std::size_t i = 0; i < errors.size(); ++i) {
      report_quantiles(std::string(name(workload)) + "_after_" + std::to_string(i), errors[i]);
    }
    EXPECT_LE(quantile(errors[3], 1), workload == Workload::w2 ? 1e-6 : 1e-14);
  }
}

}  // namespace
}  // namespace hatbox::test
