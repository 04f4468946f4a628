// The reference of the ellipse itself: against golden solid angles and, for circles, the reference of the disk.
#include "reference/ellipse_reference.h"
#include "golden/ellipse_golden.h"
#include "support/conditioning.h"
#include "support/disks.h"
#include "support/ellipses.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hatbox::test {
namespace {

using reference::DiskFrame;
using reference::EtaDisk;
using reference::EtaEllipse;

/// Axes that are all but perpendicular or of one length are made so, which is within their own rounding.
TEST(EllipseReference, SolidAngleIsGolden) {
  for (const GoldenEllipse& row : golden_ellipses) {
    double error = std::abs(EtaEllipse(row.light, row.point).solid_angle() - row.solid_angle);
    if (error > 1e-7 * row.solid_angle) {
      error -= conditioning(
          row.light, row.point, [](const Ellipse& l, const Vec3& p) { return EtaEllipse(l, p).solid_angle(); },
          [](double a, double b) { return std::abs(a - b); });
    }
    EXPECT_LE(error, 1e-7 * row.solid_angle) << "point " << row.point.x << ", " << row.point.y << ", " << row.point.z;
  }
}

TEST(EllipseReference, CirclesAreDisks) {
  const Disk disk = disk_in(Pose::canonical);
  const Ellipse light = ellipse_in(Pose::canonical, 1);
  for (const Workload workload : all_workloads) {
    const PointArrays points = make_points(workload, Pose::canonical, 300);
    const VariateArrays variates = make_variates(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const EtaDisk expected(DiskFrame<long double>(disk), points[i]);
      const EtaEllipse got(light, points[i]);
      for (const EllipseMap map : all_ellipse_maps) {
        const auto a = got.sample(map, variates.u[i], variates.v[i]);
        const auto b = expected.sample(static_cast<DiskMap>(map), variates.u[i], variates.v[i]);
        EXPECT_LE(length(a.direction - b.direction), 1e-9);
        EXPECT_NEAR(a.pdf / b.pdf, 1, 1e-9);
        EXPECT_NEAR(a.s, b.s, 1e-8);
        EXPECT_NEAR(a.t, b.t, 1e-8);
      }
    }
  }
}

}  // namespace
}  // namespace hatbox::test
