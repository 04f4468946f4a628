// DiskMap::rejection: not a bijection, so it is held by the square it tries in, by statistics and by its bound of
// tries.
#define HATBOX_ISA rejection_in_double
#include "disk_maps.h"

#include "disk_constants.h"
#include "reference/irradiance.h"
#include "support/isa_fixture.h"
#include "support/statistics.h"
#include "support/workloads.h"

#include <hatbox/hatbox.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace hatbox::test {
namespace {

using reference::Vector;

class DiskRejection : public IsaAndPoseTest {
 protected:
  Disk light() const { return disk_in(pose()); }
};

/// The bound of tries: 0.752 is the least share that the disk has in the solid angle of the square that is tried, for a
/// foot on the line through both's centre, and so few tries fail that all of them do so once in 1e9 lanes.
TEST_P(DiskRejection, DiskHasThreeQuartersOfTheSquare) {
  constexpr double least = 0.752;
  EXPECT_LT(std::pow(1 - least, rejection_in_double::DiskRejection<double>::tries), 1e-9);
  const Disk disk = disk_in(Pose::canonical);
  const Rectangle square = {{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}};
  PointArrays points;
  for (double height = 1e-6; height < 1e3; height *= 1.3) {
    for (double x = 1e-2; x < 1e3; x *= 1.02) points.push_back({float(x), 0, float(height)});
    for (double from_rim = 1e-6; from_rim < 0.5; from_rim *= 1.3) {
      points.push_back({float(1 + from_rim), 0, float(height)});
      points.push_back({float(1 - from_rim), 0, float(height)});
    }
  }
  std::vector<float> of_disk(points.size()), of_square(points.size());
  solid_angle(disk, points.view(), of_disk);
  solid_angle(square, points.view(), of_square);
  double share = 1;
  for (std::size_t i = 0; i < points.size(); ++i) share = std::min(share, double(of_disk[i]) / double(of_square[i]));
  EXPECT_GE(share, least);
  EXPECT_LE(share, least + 1e-3) << "the bound could be better";
}

/// Where the square's point of (u, v) lies on the disk, it is taken.
TEST_P(DiskRejection, FirstTryIsThePointOfTheSquare) {
  const Disk disk = disk_in(Pose::canonical);
  const Rectangle square = {{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}};
  constexpr std::size_t n = 2000;
  PointArrays points;
  for (std::size_t i = 0; i < n; ++i) points.push_back({-3.0f + 2.9f * float(i) / n, 0, 0.01f + 2.0f * float(i % 7)});
  const VariateArrays variates = make_variates(n);
  SampleArrays on_disk(n), on_square(n);
  sample(disk, DiskMap::rejection, points.view(), variates.view(), on_disk.view());
  sample(square, RectangleMap::spherical, points.view(), variates.view(), on_square.view());
  std::size_t kept = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double s = 2.0 * on_square.at(SampleArrays::s, i) - 1, t = 2.0 * on_square.at(SampleArrays::t, i) - 1;
    if (std::hypot(s, t) > 1 - 1e-5) continue;
    ++kept;
    ASSERT_NEAR(on_disk.at(SampleArrays::s, i), s, 1e-5) << i;
    ASSERT_NEAR(on_disk.at(SampleArrays::t, i), t, 1e-5) << i;
  }
  EXPECT_GT(kept, n * 3 / 4);
  EXPECT_LT(kept, n);
}

TEST_P(DiskRejection, DensityIsOneOverTheSolidAngle) {
  for (const Workload workload : all_workloads) {
    for (const std::size_t k : sample_counts) {
      const PointArrays points = make_points(workload, pose(), 12000 / k);
      const VariateArrays variates = make_variates(k * points.size());
      SampleArrays samples(variates.size());
      std::vector<float> omega(points.size());
      sample(light(), DiskMap::rejection, points.view(), variates.view(), samples.view());
      solid_angle(light(), points.view(), omega);
      for (std::size_t i = 0; i < samples.size(); ++i) {
        ASSERT_TRUE(samples.valid(i)) << name(workload) << " lane " << i;
        ASSERT_NEAR(samples.at(SampleArrays::pdf, i) * omega[i % points.size()], 1, 4e-7);
        ASSERT_LE(std::hypot(samples.at(SampleArrays::s, i), samples.at(SampleArrays::t, i)), 1 + 1e-6);
      }
    }
  }
}

/// The kernel's text in double tries the same candidates. Where one lies on the rim, float may take another.
TEST_P(DiskRejection, DirectionsMatchDouble) {
  const rejection_in_double::DiskLight<double> in_double(constants_of<double>(light()));
  for (const Workload workload : all_workloads) {
    const PointArrays points = make_points(workload, pose(), 12000);
    const VariateArrays variates = make_variates(points.size());
    SampleArrays samples(points.size());
    sample(light(), DiskMap::rejection, points.view(), variates.view(), samples.view());
    std::vector<double> errors;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const rejection_in_double::DiskRejection<double> map(in_double, points.x[i], points.y[i], points.z[i]);
      const auto expected = map.sample(variates.u[i], variates.v[i]);
      errors.push_back(
          angle_between(samples.direction(i), {expected.direction[0], expected.direction[1], expected.direction[2]}));
    }
    report_quantiles(std::string("radians_") + name(workload), errors);
    if (workload == Workload::w2) continue;  // next to the light a direction is as uncertain as its point
    EXPECT_LE(quantile(errors, 0.999), 4e-6) << name(workload);
  }
}

/// Unbiased: the irradiance of patches that see the whole light, within four standard errors.
TEST_P(DiskRejection, IrradianceIsKnown) {
  struct Patch {
    Vector<double> point, normal;  // around the canonical disk
  };
  constexpr Patch patches[] = {{{0, 0, 1}, {0.2, 0.1, -1}},
                               {{2, -1, 1}, {-2, 1.2, -1.5}},
                               {{-2.5, 2, -0.4}, {2.5, -2, 0.6}},
                               {{30, 10, 20}, {-3, -1, -1.5}}};
  const VariateArrays variates = make_variates(1 << 16);
  SampleArrays samples(variates.size());
  for (const Patch& patch : patches) {
    const Vec3 point = moved(pose(), patch.point);
    const Vector<double> normal = normalize(turned(pose(), patch.normal));
    sample(light(), DiskMap::rejection, repeat(point, 64).view(), variates.view(), samples.view());
    std::vector<double> parts;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      parts.push_back(std::max(dot(normal, samples.direction(i)), 0.0) / samples.at(SampleArrays::pdf, i));
    }
    const auto estimate = mean_and_error(parts);
    EXPECT_NEAR(estimate.mean, reference::irradiance(light(), point, normal), 4 * estimate.standard_error);
  }
}

TEST_P(DiskRejection, HasNoInverse) {
  const std::vector<float> one{1};
  std::vector<float> u{SampleArrays::untouched}, v{SampleArrays::untouched};
  const Points points{one, one, one};
  const auto complaint = [&](const auto& call) {
    try {
      call();
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  constexpr const char* expected = "map: DiskMap::rejection has no inverse";
  EXPECT_EQ(complaint([&] { invert(light(), DiskMap::rejection, points, {one, one, one}, u, v); }), expected);
  EXPECT_EQ(complaint([&] { parallel::invert(light(), DiskMap::rejection, points, {one, one, one}, u, v); }), expected);
  EXPECT_EQ(u[0], SampleArrays::untouched);
}

HATBOX_FOR_EVERY_ISA_AND_POSE(DiskRejection);

}  // namespace
}  // namespace hatbox::test
