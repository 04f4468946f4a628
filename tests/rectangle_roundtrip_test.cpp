// The calls against each other: what `sample` returns, `pdf` and `invert` must recognise; and the geometry of a sample.
#define HATBOX_ISA in_double
#include "rectangle_area_map.h"
#include "rectangle_map.h"
#include "two_triangles_map.h"

#include "rectangle_constants.h"
#include "reference/vector.h"
#include "support/conditioning.h"
#include "support/isa_fixture.h"
#include "support/opposites.h"
#include "support/rectangles.h"
#include "support/statistics.h"
#include "support/workloads.h"

#include <hatbox/hatbox.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hatbox::test {
namespace {

using reference::convert;
using reference::Vector;

/// How far a direction must be off to be off by the whole of u or of v, in radians: a float direction leaves the
/// inverse uncertain by its own rounding over these. At grazing angles lines of u and of v look almost the same.
struct DirectionGrain {
  double u, v;
};

class RectangleRoundTrip : public IsaAndPoseTest {
 protected:
  /// Calls check(light, map, points, variates, samples) for every shape and map, with one and three samples a point.
  template <class Check>
  void for_every_sampling(Workload workload, Check check) const {
    for (const Shape shape : all_shapes) {
      for (const RectangleMap map : all_rectangle_maps) {
        for (const std::size_t k : sample_counts) {
          const Rectangle light = rectangle_in(pose(), shape);
          const PointArrays points = make_points(workload, pose(), 6000 / k);
          const VariateArrays variates = make_variates(k * points.size());
          SampleArrays samples(variates.size());
          sample(light, map, points.view(), variates.view(), samples.view());
          SCOPED_TRACE(std::string(name(workload)) + " " + name(shape) + " " + name(map) + " k " + std::to_string(k));
          check(light, map, points, variates, samples);
        }
      }
    }
  }
};

/// By small steps of the samples themselves.
std::vector<DirectionGrain> grains(const Rectangle& light, RectangleMap map, const PointArrays& points,
                                   const VariateArrays& variates) {
  constexpr float step = 0x1p-7f;
  const auto sampled = [&](float du, float dv) {
    VariateArrays moved = variates;
    for (std::size_t i = 0; i < moved.size(); ++i) {
      moved.u[i] += moved.u[i] < 0.5f ? du : -du;
      moved.v[i] += moved.v[i] < 0.5f ? dv : -dv;
    }
    SampleArrays samples(moved.size());
    sample(light, map, points.view(), moved.view(), samples.view());
    return samples;
  };
  const SampleArrays here = sampled(0, 0), by_u = sampled(step, 0), by_v = sampled(0, step);
  std::vector<DirectionGrain> result;
  for (std::size_t i = 0; i < here.size(); ++i) {
    const Vector<double> along_u = by_u.direction(i) - here.direction(i),
                         along_v = by_v.direction(i) - here.direction(i);
    const double area = length(cross(along_u, along_v)) / static_cast<double>(step);
    result.push_back({area / length(along_v), area / length(along_u)});
  }
  return result;
}

TEST_P(RectangleRoundTrip, InvertUndoesSample) {
  for_every_sampling(Workload::w1, [&](const Rectangle& light, RectangleMap map, const PointArrays& points,
                                       const VariateArrays& variates, const SampleArrays& samples) {
    if (map == RectangleMap::two_triangles) return;  // below
    std::vector<float> u(samples.size()), v(samples.size());
    invert(light, map, points.view(), samples.directions(), u, v);
    const std::vector<DirectionGrain> grain = grains(light, map, points, variates);
    constexpr double rounding = 2.5e-7;  // of a direction, radians
    std::vector<double> errors, beyond;
    for (std::size_t i = 0; i < u.size(); ++i) {
      const double off_u = std::abs(u[i] - variates.u[i]), off_v = std::abs(v[i] - variates.v[i]);
      errors.push_back(std::max(off_u, off_v));
      beyond.push_back(std::max(off_u - rounding / grain[i].u, off_v - rounding / grain[i].v));
    }
    report_quantiles("uv_error", errors);
    report_quantiles("uv_error_beyond_the_direction's", beyond);
    EXPECT_LE(quantile(beyond, 0.999), 1e-5);
  });
}

/// As right as the inverse of a triangle's map.
TEST_P(RectangleRoundTrip, InvertUndoesSampleOfTwoTriangles) {
  for_every_sampling(Workload::w1, [&](const Rectangle& light, RectangleMap map, const PointArrays& points,
                                       const VariateArrays& variates, const SampleArrays& samples) {
    if (map != RectangleMap::two_triangles) return;
    const in_double::RectangleLight<double> known(constants_of<double>(light));
    std::vector<float> u(samples.size()), v(samples.size());
    invert(light, map, points.view(), samples.directions(), u, v);
    std::vector<double> errors, beyond;
    for (std::size_t i = 0; i < u.size(); ++i) {
      const double error = std::max(std::abs(u[i] - variates.u[i]), std::abs(v[i] - variates.v[i]));
      errors.push_back(error);
      beyond.push_back(error);
      if (error <= 1e-4) continue;
      const Vec3 p = points[i % points.size()];  // a sliver is narrower than 1e4 float directions
      const in_double::RectangleTwoTriangles<double> seen(known, p.x, p.y, p.z);
      beyond.back() = std::max(error - 4 * inverse_conditioning(seen, samples.direction(i)), 0.0);
    }
    report_quantiles("uv_error", errors);
    report_quantiles("uv_error_beyond_the_direction's", beyond);
    EXPECT_LE(quantile(beyond, 0.999), 1e-4);
  });
}

TEST_P(RectangleRoundTrip, InvertStaysInTheSquareOrMisses) {
  for (const Workload workload : all_workloads) {
    for_every_sampling(workload, [](const Rectangle& light, RectangleMap map, const PointArrays& points,
                                    const VariateArrays&, const SampleArrays& samples) {
      std::vector<float> u(samples.size()), v(samples.size());
      invert(light, map, points.view(), samples.directions(), u, v);
      for (std::size_t i = 0; i < u.size(); ++i) {
        const bool inside = u[i] >= 0 && u[i] < 1 && v[i] >= 0 && v[i] < 1;
        ASSERT_TRUE(inside || (u[i] == -1 && v[i] == -1)) << u[i] << ", " << v[i];
      }
    });
  }
}

TEST_P(RectangleRoundTrip, PdfOfPlaceIsThatOfSample) {
  for (const Workload workload : all_workloads) {
    for_every_sampling(workload, [](const Rectangle& light, RectangleMap map, const PointArrays& points,
                                    const VariateArrays&, const SampleArrays& samples) {
      std::vector<float> at_place(samples.size());
      pdf(light, map, points.view(), samples.places(), at_place);
      for (std::size_t i = 0; i < at_place.size(); ++i) {
        ASSERT_TRUE(samples.valid(i));
        ASSERT_NEAR(at_place[i] / samples.at(SampleArrays::pdf, i), 1, 1e-5);
      }
    });
  }
}

/// The solid-angle map's density is one number; that of area sampling goes like distance³ at grazing angles, where a
/// float direction does not tell the distance better than its rounding over the cosine.
TEST_P(RectangleRoundTrip, PdfOfDirectionIsThatOfSample) {
  for (const Workload workload : {Workload::w1, Workload::w2}) {
    for_every_sampling(workload, [](const Rectangle& light, RectangleMap map, const PointArrays& points,
                                    const VariateArrays&, const SampleArrays& samples) {
      std::vector<float> of_direction(samples.size());
      pdf(light, map, points.view(), samples.directions(), of_direction);
      for (std::size_t i = 0; i < of_direction.size(); ++i) {
        const double cosine = std::abs(static_cast<double>(samples.at(SampleArrays::cosine, i)));
        const double unknown = map == RectangleMap::area ? 3 * 4e-7 / cosine : 0;
        const double ratio = static_cast<double>(of_direction[i] / samples.at(SampleArrays::pdf, i));
        if (unknown > 0.1) continue;
        ASSERT_NEAR(ratio, 1, 1e-5 + 2 * unknown) << cosine;
      }
    });
  }
}

TEST_P(RectangleRoundTrip, AwayFromTheLightIsAMiss) {
  for_every_sampling(Workload::w1,
                     [](const Rectangle& light, RectangleMap map, const PointArrays& points, const VariateArrays&,
                        SampleArrays& samples) { expect_opposites_miss(light, map, points.view(), samples); });
}

/// Directions to places around the rim: hits inside, misses from a little outside on.
TEST_P(RectangleRoundTrip, OutsideTheRimIsAMiss) {
  const Rectangle light = rectangle_in(pose(), Shape::square);
  const PointArrays points = make_points(Workload::w1, pose(), 300);
  const auto corner = convert<double>(light.corner), edge_u = convert<double>(light.edge_u),
             edge_v = convert<double>(light.edge_v);
  for (const double margin : {-1e-3, 1e-3, 0.1}) {
    for (const auto& [s, t] :
         {std::pair{-margin, 0.3}, std::pair{1 + margin, 0.6}, std::pair{0.2, -margin}, std::pair{0.7, 1 + margin}}) {
      std::vector<float> x, y, z, density(points.size()), u(points.size()), v(points.size());
      for (std::size_t i = 0; i < points.size(); ++i) {
        const auto direction = normalize(corner + s * edge_u + t * edge_v - convert<double>(points[i]));
        x.push_back(static_cast<float>(direction.x));
        y.push_back(static_cast<float>(direction.y));
        z.push_back(static_cast<float>(direction.z));
      }
      for (const RectangleMap map : all_rectangle_maps) {
        pdf(light, map, points.view(), Directions{x, y, z}, density);
        invert(light, map, points.view(), {x, y, z}, u, v);
        for (std::size_t i = 0; i < points.size(); ++i) {
          ASSERT_EQ(density[i] > 0, margin < 0) << s << ", " << t;
          ASSERT_EQ(u[i] == -1 && v[i] == -1, margin > 0) << s << ", " << t;
        }
      }
    }
  }
}

TEST_P(RectangleRoundTrip, PlaceOutsideIsAMiss) {
  const PointArrays points = make_points(Workload::w1, pose(), 100);
  for (const RectangleMap map : all_rectangle_maps) {
    for (const float off : {-1.0f, -1e-4f, 0.0f, 0.5f, 1.0f, 1.0001f, 2.0f}) {
      const bool inside = off >= 0 && off <= 1;
      const std::vector<float> a(points.size(), off), b(points.size(), 0.4f);
      std::vector<float> density(points.size());
      for (const Places& places : {Places{a, b}, Places{b, a}}) {
        pdf(rectangle_in(pose(), Shape::square), map, points.view(), places, density);
        for (const float value : density) ASSERT_EQ(value > 0, inside) << name(map) << " at " << off;
      }
    }
  }
}

/// The way along the direction and the way over the light's edges end at the same point.
TEST_P(RectangleRoundTrip, PlaceIsWhereTheDirectionEnds) {
  for (const Workload workload : all_workloads) {
    for_every_sampling(workload, [&](const Rectangle& light, RectangleMap map, const PointArrays& points,
                                     const VariateArrays&, const SampleArrays& samples) {
      const auto corner = convert<double>(light.corner), edge_u = convert<double>(light.edge_u),
                 edge_v = convert<double>(light.edge_v);
      const auto normal = normalize(cross(edge_u, edge_v));
      const double size = std::max(length(edge_u), length(edge_v));
      std::vector<double> gaps, unit_errors, cosine_errors;
      for (std::size_t i = 0; i < samples.size(); ++i) {
        const double s = samples.at(SampleArrays::s, i), t = samples.at(SampleArrays::t, i);
        const double distance = samples.at(SampleArrays::distance, i);
        const Vector<double> direction = samples.direction(i);
        const auto along = convert<double>(points[i % points.size()]) + distance * direction;
        gaps.push_back(length(along - (corner + s * edge_u + t * edge_v)) / std::max(distance, size));
        unit_errors.push_back(std::abs(length(direction) - 1));
        cosine_errors.push_back(std::abs(samples.at(SampleArrays::cosine, i) + dot(direction, normal)));
      }
      // Area sampling takes the difference of point and corner as rounded, which is all that the pose leaves it.
      const double bound = map == RectangleMap::area && pose() == Pose::general ? 8e-6 : 2e-6;
      EXPECT_LE(quantile(gaps, 1), bound);
      EXPECT_LE(quantile(unit_errors, 1), 1e-6);
      EXPECT_LE(quantile(cosine_errors, 1), bound);
    });
  }
}

HATBOX_FOR_EVERY_ISA_AND_POSE(RectangleRoundTrip);

}  // namespace
}  // namespace hatbox::test
