// How right the numbers of a disk are: against golden values, against the double-precision reference, and how uniform
// the solid-angle maps are.
#include "golden/disk_golden.h"
#include "reference/disk_eta_reference.h"
#include "support/disks.h"
#include "support/isa_fixture.h"
#include "support/statistics.h"
#include "support/uniformity.h"
#include "support/workloads.h"

#include <hatbox/hatbox.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace hatbox::test {
namespace {

using reference::DiskFrame;
using reference::DiskSample;
using reference::EtaDisk;
using reference::Vector;

std::string label(Workload workload, DiskMap map, std::size_t k) {
  return std::string(name(workload)) + "_" + name(map) + "_k" + std::to_string(k);
}

DiskSample reference_sample(const Disk& light, DiskMap map, const Vec3& point, float u, float v) {
  return EtaDisk(DiskFrame<long double>(light), point).sample(map, u, v);
}

/// One without a series or a polynomial in place of an integral.
bool is_baseline(DiskMap map) {
  return map == DiskMap::area || map == DiskMap::radial_carlson || map == DiskMap::parallel_carlson;
}

class DiskSolidAngle : public IsaTest {};

TEST_P(DiskSolidAngle, IsGolden) {
  std::vector<double> errors;
  for (const GoldenSolidAngle& row : golden_solid_angles) {
    float got = -1;
    solid_angle(row.light, {{&row.point.x, 1}, {&row.point.y, 1}, {&row.point.z, 1}}, {&got, 1});
    const double error = std::abs(got - row.solid_angle);
    EXPECT_LE(error, 2e-6 * row.solid_angle + 4 * row.conditioning)
        << "point " << row.point.x << ", " << row.point.y << ", " << row.point.z << ", solid angle " << row.solid_angle;
    errors.push_back(std::max(0.0, error - 4 * row.conditioning) / row.solid_angle);
  }
  report_quantiles("relative_error_beyond_conditioning", errors);
}

HATBOX_FOR_EVERY_ISA(DiskSolidAngle);

class DiskAccuracy : public IsaAndPoseTest {};

/// Σ |∂direction/∂xᵢ| ulp(xᵢ) over the coordinates of point, centre and normal, by steps of one ulp.
double direction_conditioning(Disk light, DiskMap map, Vec3 point, float u, float v) {
  double sum = 0;
  for (float* x : {&point.x, &point.y, &point.z, &light.center.x, &light.center.y, &light.center.z, &light.normal.x,
                   &light.normal.y, &light.normal.z}) {
    const float here = *x;
    *x = here + static_cast<float>(ulp(here));
    const Vector<double> ahead = reference_sample(light, map, point, u, v).direction;
    *x = here - static_cast<float>(ulp(here));
    const Vector<double> behind = reference_sample(light, map, point, u, v).direction;
    *x = here;
    sum += length(ahead - behind) / 2;
  }
  return sum;
}

/// What a test knows before any kernel runs, made once for all instruction sets.
struct DirectionCase {
  PointArrays points;
  VariateArrays variates;
  std::vector<Vector<double>> directions;
};

const DirectionCase& direction_case(Workload workload, DiskMap map, Pose pose, std::size_t k) {
  static std::map<std::tuple<Workload, DiskMap, Pose, std::size_t>, DirectionCase> cases;
  DirectionCase& result = cases[{workload, map, pose, k}];
  if (result.directions.empty()) {
    const std::size_t n = (workload == Workload::w1 ? 20000 : 3000) / k;
    result.points = make_points(workload, pose, n);
    result.variates = make_variates(k * n);
    for (std::size_t i = 0; i < k * n; ++i) {
      result.directions.push_back(
          reference_sample(disk_in(pose), map, result.points[i % n], result.variates.u[i], result.variates.v[i])
              .direction);
    }
  }
  return result;
}

/// Angles to the reference; those above the bound less what the inputs' own rounding explains.
std::vector<double> direction_errors(const DirectionCase& given, DiskMap map, Pose pose, double bound) {
  SampleArrays got(given.variates.size());
  sample(disk_in(pose), map, given.points.view(), given.variates.view(), got.view());
  std::vector<double> errors;
  for (std::size_t i = 0; i < got.size(); ++i) {
    double error = got.valid(i) ? angle_between(got.direction(i), given.directions[i]) : 1;
    if (error > bound && got.valid(i)) {
      const Vec3 point = given.points[i % given.points.size()];
      error -= 4 * direction_conditioning(disk_in(pose), map, point, given.variates.u[i], given.variates.v[i]);
    }
    errors.push_back(std::max(error, 0.0));
  }
  return errors;
}

TEST_P(DiskAccuracy, DirectionsMatchReference) {
  for (const DiskMap map : disk_bijections) {
    for (const Workload workload : all_workloads) {
      for (const std::size_t k : sample_counts) {
        constexpr double bound = 4e-6, bound_hugging = 1e-4;
        const auto errors = direction_errors(direction_case(workload, map, pose(), k), map, pose(), bound);
        report_quantiles("radians_" + label(workload, map, k), errors);
        if (workload == Workload::w2) {
          EXPECT_LE(quantile(errors, 0.99), is_baseline(map) ? bound : bound_hugging) << label(workload, map, k);
        } else {
          EXPECT_LE(quantile(errors, 0.9999), bound) << label(workload, map, k);
        }
      }
    }
  }
}

HATBOX_FOR_EVERY_ISA_AND_POSE(DiskAccuracy);

class DiskUniformitySlow : public IsaAndPoseTest {};

TEST_P(DiskUniformitySlow, DensityTimesSolidAngleIsOne) {
  for (const DiskMap map :
       {DiskMap::ld_radial, DiskMap::radial, DiskMap::parallel, DiskMap::radial_carlson, DiskMap::parallel_carlson}) {
    const Sampler sampler(name(map), disk_in(pose()), map);
    const auto variations_in = [&](Workload workload, std::size_t n, std::size_t side) {
      return variations(sampler, make_points(workload, pose(), n), side);
    };
    constexpr std::size_t sides[] = {1, 16};  // one sample a point, and many that share the set-up
    for (const std::size_t side : sides) {
      const std::size_t n = side == 1 ? 20000 : 2000;
      const auto w1 = variations_in(Workload::w1, n, side);
      const auto w2 = variations_in(Workload::w2, n, side);
      const auto w3 = variations_in(Workload::w3, n, side);
      report_quantiles("variation_" + label(Workload::w1, map, side * side), w1);
      report_quantiles("variation_" + label(Workload::w2, map, side * side), w2);
      report_quantiles("variation_" + label(Workload::w3, map, side * side), w3);
      if (is_baseline(map)) {
        for (const auto& all : {w1, w2, w3}) EXPECT_LE(quantile(all, 1), 2e-6);
        continue;
      }
      EXPECT_LE(quantile(w1, 0.999), 1e-4);
      EXPECT_LE(quantile(w3, 1), 1e-6);
      EXPECT_LE(quantile(w2, 0.99), 2e-2);
    }
  }
}

HATBOX_FOR_WIDE_ISAS_AND_POSE(DiskUniformitySlow);

}  // namespace
}  // namespace hatbox::test
