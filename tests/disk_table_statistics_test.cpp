// DiskTable as a sampler: it integrates what is known, whatever its resolution, and its directions are distributed as
// their densities say.
#include "reference/disk_eta_reference.h"
#include "reference/irradiance.h"
#include "support/isa_fixture.h"
#include "support/statistics.h"
#include "support/workloads.h"

#include <hatbox/hatbox.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hatbox::test {
namespace {

using reference::DiskFrame;
using reference::EtaDisk;
using reference::Vector;

class DiskTableStatisticsSlow : public IsaAndPoseTest {
 protected:
  static const std::vector<DiskTable>& tables() {
    static const std::vector<DiskTable> result{DiskTable(DiskMap::ld_radial, 8), DiskTable(DiskMap::ld_radial, 64),
                                               DiskTable(DiskMap::radial, 1024)};
    return result;
  }
};

struct Patch {
  Vector<double> point, normal;  // around the canonical disk, all of which it sees
};
constexpr Patch patches[] = {{{0, 0, 1}, {0.2, 0.1, -1}},
                             {{0.5, 0.2, 0.3}, {0, 0, -1}},
                             {{2, -1, 1}, {-2, 1.2, -1.5}},
                             {{30, 10, 20}, {-3, -1, -1.5}}};

TEST_P(DiskTableStatisticsSlow, IrradianceIsKnown) {
  constexpr std::size_t points = 1024;
  const VariateArrays variates = make_stratified(1, 1024);
  SampleArrays samples(variates.size());
  for (const Patch& patch : patches) {
    const Vec3 point = moved(pose(), patch.point);
    const Vector<double> normal = normalize(turned(pose(), patch.normal));
    const double expected = reference::irradiance(disk_in(pose()), point, normal);
    for (const DiskTable& table : tables()) {
      sample(disk_in(pose()), table, repeat(point, points).view(), variates.view(), samples.view());
      double sum = 0;
      for (std::size_t i = 0; i < samples.size(); ++i) {
        sum += std::max(dot(normal, samples.direction(i)), 0.0) / static_cast<double>(samples.at(SampleArrays::pdf, i));
      }
      EXPECT_NEAR(sum / static_cast<double>(samples.size()) / expected, 1, 1e-5)
          << table.resolution() << " at " << point.x << ", " << point.y << ", " << point.z;
    }
  }
}

/// 16 × 16 cells of equal solid angle. The densities differ by less than a thousandth here, which this number of
/// samples does not show.
TEST_P(DiskTableStatisticsSlow, DirectionsFollowTheDensity) {
  constexpr std::size_t side = 16, points = 64;
  constexpr Vector<double> places[] = {{0.3, 0.1, 2}, {2, 1.5, 0.5}, {-1.1, 0.2, -0.1}, {0.4, 0.3, 1e-3}};
  const int tests = static_cast<int>(std::size(places) * tables().size() * available_isas().size()) * 2;
  const VariateArrays variates = make_variates(1 << 15);
  SampleArrays samples(variates.size());
  for (const Vector<double>& local : places) {
    const Vec3 point = moved(pose(), local);
    const EtaDisk disk(DiskFrame<long double>(disk_in(pose())), point);
    for (const DiskTable& table : tables()) {
      sample(disk_in(pose()), table, repeat(point, points).view(), variates.view(), samples.view());
      std::vector<double> observed(side * side);
      for (std::size_t i = 0; i < samples.size(); ++i) {
        const auto at = disk.locate(samples.direction(i));
        const double turns = at.theta / (2 * std::numbers::pi);
        const auto step = [](double x) { return std::min(static_cast<std::size_t>(x * side), side - 1); };
        ++observed[step(std::clamp(at.t, 0.0, 1.0)) * side + step(turns - std::floor(turns))];
      }
      const std::vector<double> expected(side * side, static_cast<double>(samples.size()) / (side * side));
      EXPECT_GE(chi_square_p_value(expected, observed), sidak_level(0.01, tests))
          << table.resolution() << " at " << point.x << ", " << point.y << ", " << point.z;
    }
  }
}

HATBOX_FOR_WIDE_ISAS_AND_POSE(DiskTableStatisticsSlow);

}  // namespace
}  // namespace hatbox::test
