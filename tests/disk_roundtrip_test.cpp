// The calls against each other: what `sample` returns, `pdf` and `invert` must recognise; and the geometry of a sample.
#include "reference/disk_eta_reference.h"
#include "support/conditioning.h"
#include "support/disks.h"
#include "support/isa_fixture.h"
#include "support/opposites.h"
#include "support/statistics.h"
#include "support/workloads.h"

#include <hatbox/hatbox.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hatbox::test {
namespace {

using reference::convert;
using reference::DiskFrame;
using reference::EtaDisk;
using reference::Vector;

class DiskRoundTrip : public IsaAndPoseTest {
 protected:
  static constexpr std::size_t samples_in_all = 12000;

  /// Calls `check(map, points, variates, samples)` for every map, with one and three samples a point.
  template <class Check>
  void for_every_sampling(Workload workload, Check check) const {
    for_samplings_by(all_disk_maps, workload, check);
  }

  template <class Maps, class Check>
  void for_samplings_by(const Maps& maps, Workload workload, Check check) const {
    for (const DiskMap map : maps) {
      for (const std::size_t k : sample_counts) {
        const PointArrays points = make_points(workload, pose(), samples_in_all / k);
        const VariateArrays variates = make_variates(k * points.size());
        SampleArrays samples(variates.size());
        sample(light(), map, points.view(), variates.view(), samples.view());
        SCOPED_TRACE(std::string(name(workload)) + " " + name(map) + " k = " + std::to_string(k));
        check(map, points, variates, samples);
      }
    }
  }

  Disk light() const { return disk_in(pose()); }
};

/// Where the float direction still tells (u, v): not where u wraps around, and not where the centre or a short slice
/// hides it.
bool away_from_seam(DiskMap map, float u, float v) {
  const bool inside = u > 0.001f && u < 0.999f;
  switch (map) {
    case DiskMap::parallel:
    case DiskMap::parallel_carlson: return inside;
    case DiskMap::radial:
    case DiskMap::radial_carlson: return inside && v > 0.01f;
    default: return true;
  }
}

TEST_P(DiskRoundTrip, InvertUndoesSample) {
  for_samplings_by(
      disk_bijections, Workload::w1,
      [&](DiskMap map, const PointArrays& points, const VariateArrays& variates, const SampleArrays& samples) {
        std::vector<float> u(samples.size()), v(samples.size());
        std::vector<double> errors;
        invert(light(), map, points.view(), samples.directions(), u, v);
        for (std::size_t i = 0; i < u.size(); ++i) {
          if (!away_from_seam(map, variates.u[i], variates.v[i])) continue;
          const double error = std::max(std::abs(u[i] - variates.u[i]), std::abs(v[i] - variates.v[i]));
          errors.push_back(error);
        }
        report_quantiles(std::string("uv_error_") + name(map), errors);
        EXPECT_LE(quantile(errors, 1), 1e-4);
      });
}

/// Also across the seam, and where a float direction cannot tell a hit from a miss.
TEST_P(DiskRoundTrip, InvertStaysInTheSquareOrMisses) {
  for (const Workload workload : all_workloads) {
    for_samplings_by(disk_bijections, workload,
                     [&](DiskMap map, const PointArrays& points, const VariateArrays&, const SampleArrays& samples) {
                       std::vector<float> u(samples.size()), v(samples.size());
                       invert(light(), map, points.view(), samples.directions(), u, v);
                       for (std::size_t i = 0; i < u.size(); ++i) {
                         const bool inside = u[i] >= 0 && u[i] <= 1 && v[i] >= 0 && v[i] <= 1;
                         ASSERT_TRUE(inside || (u[i] == -1 && v[i] == -1)) << u[i] << ", " << v[i];
                       }
                     });
  }
}

TEST_P(DiskRoundTrip, PdfOfPlaceIsThatOfSample) {
  for_every_sampling(Workload::w1,
                     [&](DiskMap map, const PointArrays& points, const VariateArrays&, const SampleArrays& samples) {
                       std::vector<float> at_place(samples.size());
                       std::vector<double> errors;
                       pdf(light(), map, points.view(), samples.places(), at_place);
                       for (std::size_t i = 0; i < at_place.size(); ++i) {
                         errors.push_back(std::abs(at_place[i] / samples.at(SampleArrays::pdf, i) - 1.0));
                       }
                       report_quantiles(std::string("pdf_of_place_") + name(map), errors);
                       EXPECT_LE(quantile(errors, 1), 1e-5);
                     });
}

TEST_P(DiskRoundTrip, PdfOfDirectionIsThatOfSample) {
  const DiskFrame<long double> frame(light());
  for_every_sampling(
      Workload::w1, [&](DiskMap map, const PointArrays& points, const VariateArrays&, const SampleArrays& samples) {
        std::vector<float> of_direction(samples.size());
        std::vector<double> errors;
        pdf(light(), map, points.view(), samples.directions(), of_direction);
        for (std::size_t i = 0; i < of_direction.size(); ++i) {
          double error = std::abs(of_direction[i] / samples.at(SampleArrays::pdf, i) - 1.0);
          if (error > 1e-5) {
            error -= 4 * pdf_conditioning(EtaDisk(frame, points[i % points.size()]), map, samples.direction(i));
          }
          errors.push_back(std::max(error, 0.0));
        }
        report_quantiles(std::string("pdf_of_direction_") + name(map), errors);
        EXPECT_LE(quantile(errors, 1), 1e-5);
      });
}

/// Every sample is a hit: at its place always, in its direction where the light is wider than a float direction's grain
/// and the direction clear of the light's plane by as much.
TEST_P(DiskRoundTrip, NoSampleMisses) {
  constexpr double resolvable = 1e-6;
  const DiskFrame<long double> frame(light());
  for (const Workload workload : all_workloads) {
    for_every_sampling(workload,
                       [&](DiskMap map, const PointArrays& points, const VariateArrays&, const SampleArrays& samples) {
                         std::vector<float> of_direction(samples.size()), at_place(samples.size());
                         pdf(light(), map, points.view(), samples.directions(), of_direction);
                         pdf(light(), map, points.view(), samples.places(), at_place);
                         for (std::size_t i = 0; i < samples.size(); ++i) {
                           ASSERT_TRUE(samples.valid(i)) << i;
                           ASSERT_GT(at_place[i], 0) << i;
                           if (of_direction[i] > 0 || std::abs(samples.at(SampleArrays::cosine, i)) < resolvable)
                             continue;
                           ASSERT_LT(EtaDisk(frame, points[i % points.size()]).semi_axes().b, resolvable) << i;
                         }
                       });
  }
}

/// Directions around the rim, `margin` radians inside (negative) or outside of it.
std::vector<Vector<double>> around_rim(const EtaDisk& disk, double margin) {
  std::vector<Vector<double>> result;
  const Vector<double> center = disk.at({0, 0}).direction;
  for (int i = 0; i < 21; ++i) {
    const double theta = 0.1 + 0.3 * i;
    const Vector<double> rim = disk.at({theta, 1}).direction;
    // Away from the rim at right angles to it, so that the margin is the distance even for a narrow ellipse.
    const Vector<double> along = disk.at({theta + 1e-5, 1}).direction - disk.at({theta - 1e-5, 1}).direction;
    Vector<double> away = normalize(cross(along, rim));
    if (dot(away, rim - center) < 0) away = -1.0 * away;
    result.push_back(normalize(rim + std::tan(margin) * away));
  }
  return result;
}

/// The margin in favour of a hit is a few ulp of the direction's coordinates, its length among them: up to 1.3e-5 rad
/// where the cone is as wide as W1 has it.
TEST_P(DiskRoundTrip, OutsideTheRimIsAMiss) {
  const DiskFrame<long double> frame(light());
  const PointArrays points = make_points(Workload::w1, pose(), 200);
  for (const double margin : {-4e-6, 2e-5, 1e-3, 0.1}) {
    for (std::size_t p = 0; p < points.size(); ++p) {
      const auto directions = around_rim(EtaDisk(frame, points[p]), margin);
      const std::size_t n = directions.size();
      std::vector<float> x, y, z, density(n), u(n), v(n);
      for (const Vector<double>& d : directions) {
        x.push_back(static_cast<float>(d.x));
        y.push_back(static_cast<float>(d.y));
        z.push_back(static_cast<float>(d.z));
      }
      for (const DiskMap map : disk_bijections) {
        pdf(light(), map, points.view(p, 1), Directions{x, y, z}, density);
        invert(light(), map, points.view(p, 1), {x, y, z}, u, v);
        for (std::size_t i = 0; i < n; ++i) {
          ASSERT_EQ(density[i] > 0, margin < 0) << name(map) << " point " << p << " margin " << margin;
          ASSERT_EQ(u[i] == -1 && v[i] == -1, margin > 0) << name(map) << " point " << p << " margin " << margin;
        }
      }
    }
  }
}

TEST_P(DiskRoundTrip, AwayFromTheLightIsAMiss) {
  for_samplings_by(disk_bijections, Workload::w1,
                   [&](DiskMap map, const PointArrays& points, const VariateArrays&, SampleArrays& samples) {
                     expect_opposites_miss(light(), map, points.view(), samples);
                   });
}

TEST_P(DiskRoundTrip, PlaceOutsideTheDiskIsAMiss) {
  const PointArrays points = make_points(Workload::w1, pose(), 100);
  for (const DiskMap map : all_disk_maps) {
    for (const float radius : {0.9999f, 1.0f, 1.0001f, 2.0f}) {
      const std::vector<float> s(points.size(), 0.6f * radius), t(points.size(), -0.8f * radius);
      std::vector<float> density(points.size());
      pdf(light(), map, points.view(), Places{s, t}, density);
      for (const float value : density) ASSERT_EQ(value > 0, radius <= 1) << name(map) << " radius " << radius;
    }
  }
}

/// The way along the direction and the way over the light's axes end at the same point, which lies on the disk.
TEST_P(DiskRoundTrip, PlaceIsWhereTheDirectionEnds) {
  const Axes axis = axes(light());
  const Vector<double> normal = normalize(convert<double>(light().normal));
  for (const Workload workload : {Workload::w1, Workload::w3}) {
    for_every_sampling(
        workload, [&](DiskMap, const PointArrays& points, const VariateArrays&, const SampleArrays& samples) {
          std::vector<double> gaps, unit_errors, cosine_errors;
          for (std::size_t i = 0; i < samples.size(); ++i) {
            const double s = samples.at(SampleArrays::s, i), t = samples.at(SampleArrays::t, i);
            const double distance = samples.at(SampleArrays::distance, i);
            const Vector<double> over_axes =
                convert<double>(light().center) + s * convert<double>(axis.u) + t * convert<double>(axis.v);
            const Vector<double> direction = samples.direction(i);
            const Vector<double> along = convert<double>(points[i % points.size()]) + distance * direction;
            gaps.push_back(length(along - over_axes) / std::max<double>(distance, light().radius));
            unit_errors.push_back(std::abs(length(direction) - 1));
            cosine_errors.push_back(std::abs(samples.at(SampleArrays::cosine, i) + dot(direction, normal)));
            ASSERT_LE(std::hypot(s, t), 1 + 1e-5);
          }
          report_quantiles(std::string("gap_") + name(workload), gaps);
          EXPECT_LE(quantile(gaps, 0.9999), 4e-6);
          EXPECT_LE(quantile(unit_errors, 1), 1e-6);
          EXPECT_LE(quantile(cosine_errors, 0.9999), 4e-6);
        });
  }
}

TEST_P(DiskRoundTrip, AxesSpanTheDisk) {
  for (const float scale : {1.0f, 0x1p20f, 0x1p-20f, 1e-30f, 1e30f}) {
    Disk scaled = light();
    scaled.normal = {scale * scaled.normal.x, scale * scaled.normal.y, scale * scaled.normal.z};
    const Axes axis = axes(scaled);
    const auto u = convert<double>(axis.u), v = convert<double>(axis.v);
    const auto normal = normalize(convert<double>(scaled.normal));
    const double radius = scaled.radius;
    EXPECT_NEAR(length(u) / radius, 1, 2e-7);
    EXPECT_NEAR(length(v) / radius, 1, 2e-7);
    EXPECT_NEAR(dot(u, v) / (radius * radius), 0, 2e-7);
    EXPECT_NEAR(dot(u, normal) / radius, 0, 2e-7);
    EXPECT_NEAR(dot(v, normal) / radius, 0, 2e-7);
  }
}

HATBOX_FOR_EVERY_ISA_AND_POSE(DiskRoundTrip);

}  // namespace
}  // namespace hatbox::test
