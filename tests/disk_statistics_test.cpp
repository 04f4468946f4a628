// The maps as samplers: they integrate what is known, their directions are distributed as their densities say, and the
// solid-angle map is never noisier than area sampling.
#include "reference/disk_eta_reference.h"
#include "reference/irradiance.h"
#include "support/disks.h"
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
using reference::EllipsePlace;
using reference::EtaDisk;
using reference::Vector;

/// What one sample adds to an estimate of the patch's irradiance.
double contribution(const SampleArrays& samples, std::size_t i, const Vector<double>& patch) {
  if (!samples.valid(i)) return 0;
  return std::max(dot(patch, samples.direction(i)), 0.0) / static_cast<double>(samples.at(SampleArrays::pdf, i));
}

class DiskIrradianceSlow : public IsaAndPoseTest {};

struct Patch {
  Vector<double> point, normal;  // around the canonical disk
};

/// They see the whole light, so that the integrand is smooth and stratification takes full effect.
constexpr Patch tilted_patches[] = {{{0, 0, 1}, {0.2, 0.1, -1}},
                                    {{0.5, 0.2, 0.3}, {0, 0, -1}},
                                    {{2, -1, 1}, {-2, 1.2, -1.5}},
                                    {{-2.5, 2, -0.4}, {2.5, -2, 0.6}},
                                    {{30, 10, 20}, {-3, -1, -1.5}}};

TEST_P(DiskIrradianceSlow, IsKnown) {
  constexpr std::size_t points = 1024;
  const VariateArrays variates = make_stratified(1, 1024);
  SampleArrays samples(variates.size());
  const Disk light = disk_in(pose());
  for (const Patch& patch : tilted_patches) {
    const Vec3 point = moved(pose(), patch.point);
    const Vector<double> normal = normalize(turned(pose(), patch.normal));
    const double expected = reference::irradiance(light, point, normal);
    for (const DiskMap map : recommended_disk_maps) {
      sample(light, map, repeat(point, points).view(), variates.view(), samples.view());
      double sum = 0;
      for (std::size_t i = 0; i < samples.size(); ++i) sum += contribution(samples, i, normal);
      EXPECT_NEAR(sum / static_cast<double>(samples.size()) / expected, 1, map == DiskMap::area ? 1e-4 : 1e-5)
          << name(map) << " at " << point.x << ", " << point.y << ", " << point.z;
    }
  }
}

HATBOX_FOR_WIDE_ISAS_AND_POSE(DiskIrradianceSlow);

class DiskChiSquareSlow : public IsaAndPoseTest {
 protected:
  static constexpr std::size_t side = 16;  // cells across θ and t, all of the same solid angle

  static std::size_t cell(const EllipsePlace& place) {
    const double turns = place.theta / (2 * std::numbers::pi);
    const auto step = [](double x) { return std::min(static_cast<std::size_t>(x * side), side - 1); };
    return step(std::clamp(place.t, 0.0, 1.0)) * side + step(turns - std::floor(turns));
  }

  /// The probability of each cell: equal shares, or for `area` its share of the disk, as a polygon with curved sides.
  static std::vector<double> shares(const EtaDisk& disk, DiskMap map) {
    std::vector<double> result(side * side, 1.0 / (side * side));
    if (map != DiskMap::area) return result;
    for (std::size_t i = 0; i < result.size(); ++i) {
      const std::vector<Place> corners = outline(disk, i % side, i / side);
      double doubled_area = 0;
      for (std::size_t j = 0; j < corners.size(); ++j) {
        const Place p = corners[j], q = corners[(j + 1) % corners.size()];
        doubled_area += p.s * q.t - p.t * q.s;
      }
      result[i] = std::abs(doubled_area) / (2 * std::numbers::pi);
    }
    return result;
  }

 private:
  struct Place {
    double s, t;
  };

  static std::vector<Place> outline(const EtaDisk& disk, std::size_t turn_cell, std::size_t t_cell) {
    constexpr int steps = 64;  // a side
    std::vector<Place> result;
    const auto add = [&](double x, double y) {
      const double turn = (static_cast<double>(turn_cell) + x) / side, t = (static_cast<double>(t_cell) + y) / side;
      const auto at = disk.at({2 * std::numbers::pi * turn, t});
      result.push_back({at.s, at.t});
    };
    for (int i = 0; i < 4 * steps; ++i) {
      const double way = static_cast<double>(i % steps) / steps;
      constexpr double corners[][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
      const auto &from = corners[i / steps], &to = corners[i / steps + 1];
      add(from[0] + way * (to[0] - from[0]), from[1] + way * (to[1] - from[1]));
    }
    return result;
  }
};

/// A float direction cannot resolve the cells of a far light, so there the place tells the cell.
TEST_P(DiskChiSquareSlow, DirectionsFollowTheDensity) {
  constexpr Vector<double> places[] = {{0.3, 0.1, 2},      {2, 1.5, 0.5}, {-1.1, 0.2, -0.1}, {0.4, 0.3, 1e-3},
                                       {-1.02, 0.3, 0.01}, {20, 5, -10},  {3e3, 1e4, 7e3}};
  constexpr std::array maps{DiskMap::area, DiskMap::ld_radial, DiskMap::radial, DiskMap::parallel, DiskMap::rejection};
  const int tests = static_cast<int>(std::size(places) * maps.size() * available_isas().size()) * 2;
  constexpr std::size_t points = 64;
  const VariateArrays variates = make_variates(1 << 15);
  SampleArrays samples(variates.size());
  const Disk light = disk_in(pose());
  for (const Vector<double>& local : places) {
    const Vec3 point = moved(pose(), local);
    const EtaDisk disk(DiskFrame<long double>(light), point);
    for (const DiskMap map : maps) {
      sample(light, map, repeat(point, points).view(), variates.view(), samples.view());
      std::vector<double> observed(side * side), expected = shares(disk, map);
      for (double& share : expected) share *= static_cast<double>(samples.size());
      for (std::size_t i = 0; i < samples.size(); ++i) {
        ASSERT_TRUE(samples.valid(i));
        const double s = samples.at(SampleArrays::s, i), t = samples.at(SampleArrays::t, i);
        ++observed[cell(length(local) > 10 ? disk.locate(s, t) : disk.locate(samples.direction(i)))];
      }
      EXPECT_GE(chi_square_p_value(expected, observed), sidak_level(0.01, tests))
          << name(map) << " at " << point.x << ", " << point.y << ", " << point.z;
    }
  }
}

HATBOX_FOR_EVERY_ISA_AND_POSE(DiskChiSquareSlow);

class DiskNoise : public IsaAndPoseTest {
 protected:
  static constexpr std::size_t seeds = 256;

  /// For each seed the squared relative error of an estimate with 4 × 4 stratified samples.
  std::vector<double> squared_errors(DiskMap map, const Vec3& point, const Vector<double>& normal,
                                     double expected) const {
    const VariateArrays variates = make_stratified(seeds, 4);
    SampleArrays samples(variates.size());
    const Disk light = disk_in(pose());
    sample(light, map, repeat(point, seeds).view(), variates.view(), samples.view());
    std::vector<double> sums(seeds);
    for (std::size_t i = 0; i < samples.size(); ++i) sums[i % seeds] += contribution(samples, i, normal) / 16;
    for (double& sum : sums) sum = (sum / expected - 1) * (sum / expected - 1);
    return sums;
  }

  /// How much noisier ld_radial is than area, with its statistical error.
  MeanAndError excess(const Vec3& point, const Vector<double>& normal) const {
    const double expected = reference::irradiance(disk_in(pose()), point, normal);
    auto errors = squared_errors(DiskMap::ld_radial, point, normal, expected);
    const auto area = squared_errors(DiskMap::area, point, normal, expected);
    for (std::size_t i = 0; i < seeds; ++i) errors[i] -= area[i];
    return mean_and_error(errors);
  }
};

/// Far away both maps are down to the rounding of their densities, for which `solid_angle` may claim 2e-6.
TEST_P(DiskNoise, LowDistortionIsNeverWorseFacingTheCenter) {
  constexpr double rounding = 2e-6 * 2e-6;
  const Disk light = disk_in(pose());
  for (const double angle : {0.0, 0.5, 1.0, 1.45, 1.55}) {
    for (int half_decade = -4; half_decade <= 10; ++half_decade) {
      const double distance = std::pow(10, half_decade / 2.0);
      const Vec3 point = moved(pose(), {distance * std::sin(angle), 0, distance * std::cos(angle)});
      const auto facing = normalize(reference::convert<double>(light.center) - reference::convert<double>(point));
      const MeanAndError more = excess(point, facing);
      EXPECT_LE(more.mean, 4 * more.standard_error + rounding) << "distance " << distance << ", angle " << angle;
    }
  }
}

TEST_P(DiskNoise, OtherOrientationsAreReported) {
  for (const Vector<double>& local : {Vector<double>{0, 0, -1}, Vector<double>{-1, 0, 0}, Vector<double>{0, 1, -0.2}}) {
    std::vector<double> ratios;
    for (const double angle : {0.0, 0.5, 1.0, 1.45}) {
      for (int octave = -3; octave <= 7; ++octave) {
        const double distance = std::exp2(octave);
        const Vec3 point = moved(pose(), {distance * std::sin(angle), 0, distance * std::cos(angle)});
        const Vector<double> normal = normalize(turned(pose(), local));
        const double expected = reference::irradiance(disk_in(pose()), point, normal);
        if (!(expected > 0)) continue;
        const auto ld_radial = mean_and_error(squared_errors(DiskMap::ld_radial, point, normal, expected));
        const auto area = mean_and_error(squared_errors(DiskMap::area, point, normal, expected));
        ratios.push_back(ld_radial.mean / area.mean);
      }
    }
    const auto direction = testing::PrintToString(std::array{local.x, local.y, local.z});
    report_quantiles("mse_ratio_patch_facing_" + direction, ratios);
  }
}

HATBOX_FOR_EVERY_ISA_AND_POSE(DiskNoise);

}  // namespace
}  // namespace hatbox::test
