// The references themselves: the paper's equations, the form without cancellation, and 40-digit golden values must
// agree wherever each of them is good.
#include "reference/disk_reference.h"
#include "golden/disk_golden.h"
#include "reference/disk_eta_reference.h"
#include "reference/irradiance.h"
#include "support/disks.h"
#include "support/statistics.h"
#include "support/workloads.h"

#include <gtest/gtest.h>

#include <numbers>

namespace hatbox::test {
namespace {

using reference::DiskFrame;
using reference::EtaDisk;
using reference::PaperDisk;
using reference::Vector;

TEST(DiskReference, SolidAngleIsGolden) {
  for (const GoldenSolidAngle& row : golden_solid_angles) {
    const EtaDisk disk(DiskFrame<long double>(row.light), row.point);
    // The absolute part is what the projection onto the plane costs at height 1e-30, in long double.
    EXPECT_NEAR(disk.solid_angle(), row.solid_angle, 1e-13 * row.solid_angle + 1e-6 * row.conditioning);
  }
}

TEST(DiskReference, DirectionIsGolden) {
  for (const GoldenDirection& row : golden_directions) {
    const EtaDisk disk(DiskFrame<long double>(row.light), row.point);
    const Vector<double> direction = disk.sample(row.map, row.u, row.v).direction;
    EXPECT_LE(length(direction - row.direction), 1e-12);
  }
}

/// Equation 19 loses about 1e-16 / Ω, and a part of that with the shape: cos α cos β near 0 for W2.
TEST(DiskReference, PaperAgreesWhereItIsGood) {
  for (const Workload workload : {Workload::w1, Workload::w2}) {
    for (const Pose pose : {Pose::canonical, Pose::general}) {
      const Disk light = disk_in(pose);
      const PointArrays points = make_points(workload, pose, 2000);
      const VariateArrays variates = make_variates(points.size());
      std::vector<double> area_errors, angle_errors;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const PaperDisk paper(DiskFrame<double>(light), points[i]);
        const EtaDisk eta(DiskFrame<long double>(light), points[i]);
        if (eta.solid_angle() < 1e-2) continue;
        area_errors.push_back(std::abs(paper.solid_angle() / eta.solid_angle() - 1));
        for (const DiskMap map : disk_bijections) {
          const float u = variates.u[i], v = variates.v[i];
          angle_errors.push_back(angle_between(paper.sample(map, u, v).direction, eta.sample(map, u, v).direction));
        }
      }
      EXPECT_LE(quantile(area_errors, 1), workload == Workload::w1 ? 1e-10 : 1e-7);
      EXPECT_LE(quantile(angle_errors, 0.99), workload == Workload::w1 ? 1e-10 : 1e-6);
    }
  }
}

/// Means of Newton steps on W1: with the right derivative 3 to 5, with the published one over 50.
TEST(DiskReference, PaperNeedsFewNewtonSteps) {
  const Disk light = disk_in(Pose::canonical);
  const PointArrays points = make_points(Workload::w1, Pose::canonical, 2000);
  const VariateArrays variates = make_variates(points.size());
  const auto mean_steps = [&](const std::string& what, double most, const auto& steps_of) {
    std::vector<double> steps;
    for (std::size_t i = 0; i < points.size(); ++i) {
      steps.push_back(steps_of(PaperDisk(DiskFrame<double>(light), points[i]), variates.u[i], variates.v[i]));
    }
    report_quantiles("newton_steps_" + what, steps);
    EXPECT_LE(quantile(steps, 1), most) << what;
    return mean_and_error(steps).mean;
  };
  for (const DiskMap map : {DiskMap::ld_radial, DiskMap::radial, DiskMap::parallel}) {
    EXPECT_LE(mean_steps(name(map), 8,
                         [&](const PaperDisk& disk, float u, float v) { return disk.sample(map, u, v).iterations; }),
              5)
        << name(map);
  }
  EXPECT_GE(mean_steps("published", 100, [](const PaperDisk& disk, float u, float) { return disk.published_steps(u); }),
            50);
}

TEST(DiskReference, LocateInvertsDirection) {
  const Disk light = disk_in(Pose::general);
  const PointArrays points = make_points(Workload::w2, Pose::general, 500);
  const VariateArrays variates = make_variates(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const EtaDisk disk(DiskFrame<long double>(light), points[i]);
    const double theta = 6.2 * (variates.u[i] - 0.5), t = 0.01 + 0.9 * variates.v[i];
    const auto place = disk.locate(disk.at({theta, t}).direction);
    EXPECT_NEAR(place.theta, theta, 1e-6);
    EXPECT_NEAR(place.t, t, 1e-6);
  }
}

TEST(DiskReference, IrradianceHasItsClosedForms) {
  const Disk light = disk_in(Pose::canonical);
  for (const float z : {0.01f, 1.0f, 100.0f, 1e5f}) {
    const double facing = reference::irradiance(light, {0, 0, z}, {0, 0, -1});
    const double sine_squared = 1 / (1 + static_cast<double>(z) * static_cast<double>(z));
    EXPECT_NEAR(facing / (std::numbers::pi * sine_squared), 1, 1e-10);
    // At right angles to the disk the horizon halves it, which needs the chord: E = atan(1/z) − z/(1+z²).
    const double upright = reference::irradiance(light, {0, 0, z}, {1, 0, 0});
    const double height = static_cast<double>(z);
    EXPECT_NEAR(upright / (std::atan(1 / height) - height * sine_squared), 1, z > 10 ? 1e-4 : 1e-10);
    EXPECT_EQ(reference::irradiance(light, {0, 0, z}, {0, 0, 1}), 0);
  }
}

}  // namespace
}  // namespace hatbox::test
