// The calls for triangles against each other: what `sample` returns, `pdf` and `invert` must recognise; which
// directions and places hit; and the geometry of a sample.
#define HATBOX_ISA in_double
#include "support/triangle_reference.h"

#include "support/conditioning.h"
#include "support/isa_fixture.h"
#include "support/random.h"
#include "support/statistics.h"

#include <hatbox/hatbox.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hatbox::test {
namespace {

using reference::convert;
using reference::Vector;

class TriangleRoundTrip : public IsaAndPoseTest {
 protected:
  /// Calls `check(what, light, map, points, variates, samples)` for every triangle and map, k = 1 and 3.
  template <class Check>
  void for_every_sampling(Workload workload, const Check& check) const {
    for (const auto& [what, light] : triangles_in(pose())) {
      for (const TriangleMap map : all_triangle_maps) {
        for (const std::size_t k : sample_counts) {
          const PointArrays points = make_points(workload, pose(), 6000 / k);
          const VariateArrays variates = make_variates(k * points.size());
          SampleArrays samples(variates.size());
          sample(light, map, points.view(), variates.view(), samples.view());
          SCOPED_TRACE(what + " " + name(workload) + " " + name(map) + " k = " + std::to_string(k));
          check(what, light, map, points, variates, samples);
        }
      }
    }
  }
};

TEST_P(TriangleRoundTrip, InvertUndoesSample) {
  for_every_sampling(Workload::w1, [&](const std::string& what, const Triangle& light, TriangleMap map,
                                       const PointArrays& points, const VariateArrays& variates,
                                       const SampleArrays& samples) {
    std::vector<float> u(samples.size()), v(samples.size());
    std::vector<double> errors;
    invert(light, map, points.view(), samples.directions(), u, v);
    for (std::size_t i = 0; i < u.size(); ++i) {
      double error = std::max(std::abs(u[i] - variates.u[i]), std::abs(v[i] - variates.v[i]));
      if (what != "right" && error > 1e-4) {  // a sliver is narrower than 1e4 float directions
        error -= 4 * with_triangle_map(map, light, points[i % points.size()],
                                       [&](const auto& m) { return inverse_conditioning(m, samples.direction(i)); });
      }
      errors.push_back(std::max(error, 0.0));
    }
    report_quantiles("uv_error_" + what + "_" + name(map), errors);
    EXPECT_LE(quantile(errors, 0.999), 1e-4);
  });
}

TEST_P(TriangleRoundTrip, InvertStaysInTheSquareOrMisses) {
  for (const Workload workload : all_workloads) {
    for_every_sampling(workload, [&](const std::string&, const Triangle& light, TriangleMap map,
                                     const PointArrays& points, const VariateArrays&, const SampleArrays& samples) {
      std::vector<float> u(samples.size()), v(samples.size());
      invert(light, map, points.view(), samples.directions(), u, v);
      for (std::size_t i = 0; i < u.size(); ++i) {
        const bool inside = u[i] >= 0 && u[i] <= 1 && v[i] >= 0 && v[i] <= 1;
        ASSERT_TRUE(inside || (u[i] == -1 && v[i] == -1)) << u[i] << ", " << v[i];
      }
    });
  }
}

TEST_P(TriangleRoundTrip, PdfOfPlaceIsThatOfSample) {
  for_every_sampling(Workload::w1, [&](const std::string&, const Triangle& light, TriangleMap map,
                                       const PointArrays& points, const VariateArrays&, const SampleArrays& samples) {
    std::vector<float> at_place(samples.size());
    pdf(light, map, points.view(), samples.places(), at_place);
    for (std::size_t i = 0; i < at_place.size(); ++i) {
      ASSERT_NEAR(at_place[i] / samples.at(SampleArrays::pdf, i), 1, 1e-5);
    }
  });
}

/// The density of area sampling goes with 1/cosine³ along a ray, which a float direction knows to 1e-7/cosine.
TEST_P(TriangleRoundTrip, PdfOfDirectionIsThatOfSample) {
  for_every_sampling(Workload::w1, [&](const std::string&, const Triangle& light, TriangleMap map,
                                       const PointArrays& points, const VariateArrays&, const SampleArrays& samples) {
    std::vector<float> of_direction(samples.size());
    pdf(light, map, points.view(), samples.directions(), of_direction);
    for (std::size_t i = 0; i < of_direction.size(); ++i) {
      const double cosine = std::abs(samples.at(SampleArrays::cosine, i));
      const double slack = map == TriangleMap::area ? 3 * 4 * 0x1p-24 / cosine : 0;
      ASSERT_NEAR(of_direction[i] / samples.at(SampleArrays::pdf, i), 1, 1e-5 + slack);
    }
  });
}

TEST_P(TriangleRoundTrip, NoSampleMisses) {
  for (const Workload workload : all_workloads) {
    for_every_sampling(workload, [&](const std::string&, const Triangle& light, TriangleMap map,
                                     const PointArrays& points, const VariateArrays&, const SampleArrays& samples) {
      std::vector<float> of_direction(samples.size()), at_place(samples.size());
      pdf(light, map, points.view(), samples.directions(), of_direction);
      pdf(light, map, points.view(), samples.places(), at_place);
      for (std::size_t i = 0; i < samples.size(); ++i) {
        ASSERT_GT(at_place[i], 0) << i;
        // Area sampling meets the plane along the direction, which a float grazing it does not.
        if (map == TriangleMap::area && std::abs(samples.at(SampleArrays::cosine, i)) < 1e-6f) continue;
        ASSERT_GT(of_direction[i], 0) << i;
      }
    });
  }
}

struct Directed {
  std::vector<float> x, y, z;

  void push_back(const Vector<double>& d) {
    x.push_back(static_cast<float>(d.x));
    y.push_back(static_cast<float>(d.y));
    z.push_back(static_cast<float>(d.z));
  }
  Directions view() const { return {x, y, z}; }
};

/// Directions beside the middle parts of all sides, `margin` radians outside, or inside where it is negative.
Directed beside_the_sides(const TriangleFrom& seen, double margin) {
  Directed result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (const double way : {0.3, 0.5, 0.7}) {
      const Vector<double> on_side =
          normalize(seen.vertices[(i + 1) % 3] + way * (seen.vertices[(i + 2) % 3] - seen.vertices[(i + 1) % 3]));
      result.push_back(normalize(on_side - std::tan(margin) * seen.inwards(i)));
    }
  }
  return result;
}

/// The margin in favour of a hit is a few ulp of the direction's coordinates.
TEST_P(TriangleRoundTrip, OutsideTheSidesIsAMiss) {
  const Triangle light = triangles_in(pose())[0].light;
  const PointArrays points = make_points(Workload::w1, pose(), 200);
  for (const double margin : {-4e-6, 4e-6, 1e-3, 0.1}) {
    for (std::size_t p = 0; p < points.size(); ++p) {
      const Directed directions = beside_the_sides(TriangleFrom(light, points[p]), margin);
      const std::size_t n = directions.x.size();
      std::vector<float> density(n), u(n), v(n);
      for (const TriangleMap map : all_triangle_maps) {
        pdf(light, map, points.view(p, 1), directions.view(), density);
        invert(light, map, points.view(p, 1), directions.view(), u, v);
        for (std::size_t i = 0; i < n; ++i) {
          ASSERT_EQ(density[i] > 0, margin < 0) << name(map) << " point " << p << " margin " << margin;
          ASSERT_EQ(u[i] == -1 && v[i] == -1, margin > 0) << name(map) << " point " << p << " margin " << margin;
        }
      }
    }
  }
}

TEST_P(TriangleRoundTrip, AwayFromTheLightIsAMiss) {
  for (const Workload workload : all_workloads) {
    for_every_sampling(workload, [&](const std::string&, const Triangle& light, TriangleMap map,
                                     const PointArrays& points, const VariateArrays&, SampleArrays& samples) {
      for (const auto c : {SampleArrays::x, SampleArrays::y, SampleArrays::z}) {
        for (float& value : samples.columns[c]) value = -value;
      }
      std::vector<float> density(samples.size());
      pdf(light, map, points.view(), samples.directions(), density);
      // Right in front of the light, where it fills the half space, the edge of that is a hit on both sides.
      for (std::size_t i = 0; i < density.size(); ++i) {
        const bool may_hit = workload == Workload::w2 && std::abs(samples.at(SampleArrays::cosine, i)) <= 2e-6f;
        ASSERT_TRUE(density[i] == 0 || may_hit) << i;
      }
    });
  }
}

/// Beside the light and as good as in its plane it is a line; what lies on its continuation is a miss all the same.
TEST_P(TriangleRoundTrip, BeyondALightSeenEdgeOnIsAMiss) {
  const Triangle light = triangles_in(pose())[0].light;
  const Vec3 point = moved(pose(), {3, 0.25, 1e-7});
  Directed away;
  for (const double angle : {-2.5, -2.0, -1.0, 0.0, 1.0, 2.0, 2.6, 3.4}) {
    away.push_back(turned(pose(), {std::cos(angle), std::sin(angle), 0}));
  }
  std::vector<float> density(away.x.size());
  for (const TriangleMap map : all_triangle_maps) {
    pdf(light, map, {{&point.x, 1}, {&point.y, 1}, {&point.z, 1}}, away.view(), density);
    for (const float value : density) EXPECT_EQ(value, 0);
  }
}

TEST_P(TriangleRoundTrip, PlaceOutsideTheTriangleIsAMiss) {
  constexpr struct {
    float s, t;
    bool hit;
  } places[] = {{0, 0, true},        {1, 0, true},          {0, 1, true},          {0.5f, 0.5f, true},
                {0.2f, 0.3f, true},  {-1e-4f, 0.5f, false}, {0.5f, -1e-4f, false}, {0.5f, 0.5001f, false},
                {1.0001f, 0, false}, {2, -1.5f, false}};
  const PointArrays points = make_points(Workload::w1, pose(), 100);
  const Triangle light = triangles_in(pose())[0].light;
  for (const TriangleMap map : all_triangle_maps) {
    for (const auto& place : places) {
      const std::vector<float> s(points.size(), place.s), t(points.size(), place.t);
      std::vector<float> density(points.size());
      pdf(light, map, points.view(), Places{s, t}, density);
      for (const float value : density) ASSERT_EQ(value > 0, place.hit) << place.s << ", " << place.t;
    }
  }
}

/// The way along the direction and the way over the light's edges end at the same point, which lies on the light.
TEST_P(TriangleRoundTrip, PlaceIsWhereTheDirectionEnds) {
  for (const Workload workload : {Workload::w1, Workload::w3}) {
    for_every_sampling(workload, [&](const std::string&, const Triangle& light, TriangleMap, const PointArrays& points,
                                     const VariateArrays&, const SampleArrays& samples) {
      const auto a = convert<double>(light.a), b = convert<double>(light.b), c = convert<double>(light.c);
      const auto normal = normalize(cross(b - a, c - a));
      for (std::size_t i = 0; i < samples.size(); ++i) {
        const double s = samples.at(SampleArrays::s, i), t = samples.at(SampleArrays::t, i);
        const double distance = samples.at(SampleArrays::distance, i);
        const Vector<double> direction = samples.direction(i);
        const Vector<double> along = convert<double>(points[i % points.size()]) + distance * direction;
        const Vector<double> over_edges = a + s * (b - a) + t * (c - a);
        ASSERT_LE(length(along - over_edges), 4e-6 * std::max(distance, length(b - a)));
        ASSERT_NEAR(length(direction), 1, 1e-6);
        ASSERT_NEAR(samples.at(SampleArrays::cosine, i), -dot(direction, normal), 4e-6);
      }
    });
  }
}

HATBOX_FOR_EVERY_ISA_AND_POSE(TriangleRoundTrip);

}  // namespace
}  // namespace hatbox::test
