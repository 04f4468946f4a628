// How right the numbers of the ellipse are: against golden values, the long-double reference, and the disk; and how
// uniform its solid-angle maps are.
#include "golden/ellipse_golden.h"
#include "reference/ellipse_reference.h"
#include "support/conditioning.h"
#include "support/ellipses.h"
#include "support/isa_fixture.h"
#include "support/sampler_calls.h"
#include "support/statistics.h"
#include "support/uniformity.h"

#include <hatbox/hatbox.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <tuple>

namespace hatbox::test {
namespace {

using reference::EtaEllipse;
using reference::Vector;

std::string label(Workload workload, double aspect) {
  return std::string(name(workload)) + "_aspect_" + std::to_string(aspect);
}

double solid_angle_conditioning(const Ellipse& light, const Vec3& point) {
  return conditioning(
      light, point, [](const Ellipse& l, const Vec3& p) { return EtaEllipse(l, p).solid_angle(); },
      [](double a, double b) { return std::abs(a - b); });
}

class EllipseSolidAngle : public IsaTest {};

TEST_P(EllipseSolidAngle, IsGolden) {
  std::vector<double> errors;
  for (const GoldenEllipse& row : golden_ellipses) {
    float got = -1;
    solid_angle(row.light, {{&row.point.x, 1}, {&row.point.y, 1}, {&row.point.z, 1}}, {&got, 1});
    double error = std::abs(static_cast<double>(got) - row.solid_angle);
    if (error > 1e-7 * row.solid_angle) {
      error = std::max(0.0, error - 4 * solid_angle_conditioning(row.light, row.point));
    }
    EXPECT_LE(error, 2e-6 * row.solid_angle) << "point " << row.point.x << ", " << row.point.y << ", " << row.point.z;
    errors.push_back(error / row.solid_angle);
  }
  report_quantiles("relative_error_beyond_conditioning", errors);
}

HATBOX_FOR_EVERY_ISA(EllipseSolidAngle);

class EllipseAccuracy : public IsaAndPoseTest {};

constexpr double direction_bound = 4e-6;

/// What a test knows before any kernel runs, made once for all instruction sets.
struct DirectionCase {
  PointArrays points;
  VariateArrays variates;
  std::vector<Vector<double>> directions;
};

const DirectionCase& direction_case(Workload workload, double aspect, EllipseMap map, Pose pose, std::size_t k) {
  static std::map<std::tuple<Workload, double, EllipseMap, Pose, std::size_t>, DirectionCase> cases;
  DirectionCase& result = cases[{workload, aspect, map, pose, k}];
  if (result.directions.empty()) {
    const Ellipse light = ellipse_in(pose, aspect);
    const std::size_t n = (workload == Workload::w1 ? 10000 : 1000) / k;
    result.points = make_points(workload, pose, n);
    result.variates = make_variates(k * n);
    for (std::size_t i = 0; i < k * n; ++i) {
      const EtaEllipse ellipse(light, result.points[i % n]);
      result.directions.push_back(ellipse.sample(map, result.variates.u[i], result.variates.v[i]).direction);
    }
  }
  return result;
}

/// Angles to the reference; those above the bound less what the inputs' own rounding explains.
std::vector<double> direction_errors(Workload workload, double aspect, EllipseMap map, Pose pose, std::size_t k) {
  const DirectionCase& given = direction_case(workload, aspect, map, pose, k);
  const Ellipse light = ellipse_in(pose, aspect);
  SampleArrays got(given.variates.size());
  sample(light, map, given.points.view(), given.variates.view(), got.view());
  std::vector<double> errors;
  for (std::size_t i = 0; i < got.size(); ++i) {
    double error = got.valid(i) ? angle_between(got.direction(i), given.directions[i]) : 1;
    if (error > direction_bound && got.valid(i) && workload == Workload::w1) {
      const float u = given.variates.u[i], v = given.variates.v[i];
      error -= 4 * conditioning(
                       light, given.points[i % given.points.size()],
                       [&](const Ellipse& l, const Vec3& p) { return EtaEllipse(l, p).sample(map, u, v).direction; },
                       [](const auto& a, const auto& b) { return length(a - b); });
    }
    errors.push_back(std::max(error, 0.0));
  }
  return errors;
}

TEST_P(EllipseAccuracy, DirectionsMatchReference) {
  for (const EllipseMap map : all_ellipse_maps) {
    for (const Workload workload : all_workloads) {
      for (const std::size_t k : sample_counts) {
        for (const double aspect : ellipse_aspects) {
          const std::string what = label(workload, aspect) + "_" + name(map) + "_k" + std::to_string(k);
          const std::vector<double> errors = direction_errors(workload, aspect, map, pose(), k);
          report_quantiles("radians_" + what, errors);
          if (workload == Workload::w1) {
            EXPECT_LE(quantile(errors, 0.9999), direction_bound) << what;
          }
        }
      }
    }
  }
}

/// Axes as long as each other, of which rounding may have made one the longer.
TEST_P(EllipseAccuracy, CirclesAreDisks) {
  const Disk disk = disk_in(pose());
  const Axes axis = axes(disk);
  const Ellipse light{disk.center, axis.u, axis.v};
  for (const Workload workload : all_workloads) {
    const PointArrays points = make_points(workload, pose(), 3000);
    for (const EllipseMap map : all_ellipse_maps) {
      for (const std::size_t k : sample_counts) {
        const Sampler as_disk("disk", disk, static_cast<DiskMap>(map)), as_ellipse("ellipse", light, map);
        const Queries queries = make_queries(as_disk, points, k);
        const auto expected = call_everything(as_disk, queries), got = call_everything(as_ellipse, queries);
        for (std::size_t c = 0; c < got.size(); ++c) {
          const std::string& column = got[c].name;
          const bool relative = column.starts_with("pdf") || column == "solid_angle" || column == "distance";
          if (column == "u" || column == "v" || column == "pdf_of_direction")
            continue;                                                          // a float direction hides these
          if (column == "pdf_at_place" && workload == Workload::w2) continue;  // and a float place this
          std::vector<double> errors;
          for (std::size_t i = 0; i < got[c].values.size(); ++i) {
            const double a = got[c].values[i], b = expected[c].values[i];
            double error = std::abs(a - b) / (relative ? b : 1);
            // The normal is known no better than the axes are: from small heights the two lights are not the same.
            if (error > 1e-5 && relative && workload == Workload::w3) {
              const Vec3 point = points[i % points.size()];
              error -= 4 * solid_angle_conditioning(light, point) / EtaEllipse(light, point).solid_angle();
            }
            errors.push_back(std::max(error, 0.0));
          }
          const std::string what = std::string(name(workload)) + "_" + name(map) + "_" + column;
          report_quantiles(what, errors);
          if (pose() == Pose::general && workload == Workload::w2) continue;  // next to the plane, as above
          EXPECT_LE(quantile(errors, 1), 1e-5) << what;
        }
      }
    }
  }
}

HATBOX_FOR_EVERY_ISA_AND_POSE(EllipseAccuracy);

class EllipseUniformitySlow : public IsaAndPoseTest {};

/// What is promised of disks, and of ellipses that are no circles more: hugging the light makes no difference to them.
TEST_P(EllipseUniformitySlow, DensityTimesSolidAngleIsOne) {
  constexpr double share[] = {0.999, 0.99, 1}, bound[] = {1e-4, 2e-2, 1e-4};
  for (const EllipseMap map : {EllipseMap::ld_radial, EllipseMap::radial}) {
    for (const Workload workload : all_workloads) {
      const auto w = static_cast<std::size_t>(workload);
      for (const std::size_t side : {std::size_t{1}, std::size_t{16}}) {
        const PointArrays points = make_points(workload, pose(), side == 1 ? 20000 : 4000);
        for (const double aspect : ellipse_aspects) {
          const std::string what = label(workload, aspect) + "_" + name(map) + "_k" + std::to_string(side * side);
          const auto errors = variations(Sampler(what, ellipse_in(pose(), aspect), map), points, side);
          report_quantiles("variation_" + what, errors);
          EXPECT_LE(quantile(errors, share[w]), bound[w]) << what;
          if (aspect != 1) {
            EXPECT_LE(quantile(errors, 1), 1e-4) << what;
          }
        }
      }
    }
  }
}

HATBOX_FOR_WIDE_ISAS_AND_POSE(EllipseUniformitySlow);

}  // namespace
}  // namespace hatbox::test
