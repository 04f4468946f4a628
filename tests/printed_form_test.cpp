// What float makes of the solid angle as it is printed, Guillén et al. 2017, eq. 19, φ − cΠ: a difference of numbers
// that agree the better the smaller the light is seen. This is why no kernel evaluates it, not even those that are
// there to compare the paper's way.
#include "reference/disk_eta_reference.h"
#include "support/statistics.h"
#include "support/workloads.h"

#include <hatbox/hatbox.h>

#include <gtest/gtest.h>
#include <boost/math/special_functions/ellint_3.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

namespace hatbox::test {
namespace {

/// Equations 3, 4, 19 and 20 in float, with a Π that is right to a few ulp. For the unit disk at the origin.
float printed_solid_angle(const Vec3& point) {
  using Policy =
      boost::math::policies::policy<boost::math::policies::promote_float<false>,
                                    boost::math::policies::overflow_error<boost::math::policies::ignore_error>,
                                    boost::math::policies::domain_error<boost::math::policies::ignore_error>>;
  const float z = std::abs(point.z), d = std::hypot(point.x, point.y);
  const float l0 = std::hypot(d - 1, z), l1 = std::hypot(d + 1, z);
  const float y0 = (d - 1) / l0, z0 = z / l0, y1 = (d + 1) / l1, z1 = z / l1;
  const float chord_y = z * (y0 + y1) / (z0 + z1);
  const float chord_x = std::sqrt((1 - (chord_y - d)) * (1 + (chord_y - d)));
  const float a = chord_x / std::sqrt(chord_x * chord_x + chord_y * chord_y + z * z);
  const float b = std::min(std::hypot(y1 - y0, z1 - z0) / 2, a);
  const float a2 = a * a, b2 = b * b;
  const float n = (a2 - b2) / (a2 * (1 - b2)), k = std::sqrt((a2 - b2) / (1 - b2));
  const float c = b * (1 - a2) / (a * std::sqrt(1 - b2));
  const float quarter = std::numbers::pi_v<float> / 2 - c * boost::math::ellint_3(k, n, Policy());
  return 4 * quarter;
}

struct Losses {
  std::vector<double> printed, ours;  // relative errors of the solid angle, at most 1
};

/// Of the points from which the disk is at least `least` and less than `most` steradians.
Losses losses(Workload workload, double least, double most) {
  const Disk disk = disk_in(Pose::canonical);
  const PointArrays points = make_points(workload, Pose::canonical, 1200);
  std::vector<float> ours(points.size());
  solid_angle(disk, points.view(), ours);
  const reference::DiskFrame<long double> frame(disk);
  Losses result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto expected = static_cast<double>(reference::EtaDisk(frame, points[i]).solid_angle());
    if (!(expected >= least && expected < most)) continue;
    const auto error = [&](float got) {
      const double relative = std::abs(static_cast<double>(got) / expected - 1);
      return relative < 1 ? relative : 1;  // also for NaN
    };
    result.printed.push_back(error(printed_solid_angle(points[i])));
    result.ours.push_back(error(ours[i]));
  }
  return result;
}

TEST(PrintedFormSlow, LosesTheSolidAngleInFloat) {
  constexpr double edges[] = {1e-10, 1e-6, 1e-4, 1e-3, 1e-2, 1e-1, 1, 2 * std::numbers::pi};
  for (const Workload workload : all_workloads) {
    for (std::size_t i = 0; i + 1 < std::size(edges); ++i) {
      const Losses found = losses(workload, edges[i], edges[i + 1]);
      if (found.printed.size() < 40) continue;
      const auto lost = std::ranges::count_if(found.printed, [](double error) { return error > 0.1; });
      const double share = static_cast<double>(lost) / static_cast<double>(found.printed.size());
      std::printf("    %s, %g to %g sr: median error %.1e, %.0f %% off by 10 %% or more; ours 99 %% %.1e\n",
                  name(workload), edges[i], edges[i + 1], quantile(found.printed, 0.5), 100 * share,
                  quantile(found.ours, 0.99));
      if (edges[i + 1] <= 1e-6) {
        EXPECT_GT(share, 0.9);
      }
      EXPECT_LE(quantile(found.ours, 1), 2e-6);
    }
  }
}

}  // namespace
}  // namespace hatbox::test
