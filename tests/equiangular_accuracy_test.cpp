// Distances along rays against the paper's formulas in long double, on the inputs as they are: what they forgive is the
// rounding of the distance itself, an ulp of it.
#include "support/isa_fixture.h"
#include "support/segments.h"
#include "support/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hatbox::test {
namespace {

class EquiangularAccuracy : public IsaAndPoseTest {};

constexpr std::size_t n = 500, k = 8;

std::vector<float> distribute(std::size_t count) {
  std::vector<float> u = make_variates(count).u;
  for (std::size_t i = 0; i < u.size(); i += 50) u[i] = 0;
  for (std::size_t i = 1; i < u.size(); i += 50) u[i] = 1;  // clamped
  for (std::size_t i = 2; i < u.size(); i += 50) u[i] *= 1e-6f;
  return u;
}

TEST_P(EquiangularAccuracy, OfTheDistribution) {
  for (const Situation situation : all_situations) {
    const SegmentArrays segments = make_segments(situation, pose(), n);
    const std::vector<float> u = distribute(k * n);
    const DistanceArrays got = sample(segments, u);
    std::vector<double> errors;
    for (std::size_t i = 0; i < u.size(); ++i) {
      const reference::Equiangular exact(segments.segment(i % n), segments.pivot[i % n]);
      ASSERT_GT(got.pdf[i], 0) << name(situation) << " lane " << i;
      ASSERT_GE(got.t[i], segments.t_min[i % n]);
      ASSERT_LE(got.t[i], segments.t_max[i % n]);
      const double t = got.t[i], step = ulp(got.t[i]);
      const double before = exact.cdf(t - step), behind = exact.cdf(t + step), wanted = std::min(u[i], 1.0f);
      const double error = std::max({0.0, before - wanted, wanted - behind});
      errors.push_back(error);
      ASSERT_LE(error, 1e-6) << name(situation) << " lane " << i << " u " << u[i] << " t " << got.t[i] << " cdf "
                             << exact.cdf(t);
    }
    report_quantiles(std::string("cdf_") + name(situation), errors);
  }
}

TEST_P(EquiangularAccuracy, OfTheDensity) {
  for (const Situation situation : all_situations) {
    const SegmentArrays segments = make_segments(situation, pose(), n);
    const DistanceArrays got = sample(segments, distribute(k * n));
    const std::vector<float> asked = pdf(segments, got.t);
    std::vector<double> errors;
    for (std::size_t i = 0; i < k * n; ++i) {
      const reference::Equiangular exact(segments.segment(i % n), segments.pivot[i % n]);
      errors.push_back(std::abs(static_cast<double>(got.pdf[i]) / exact.density(got.t[i]) - 1));
      ASSERT_LE(errors.back(), 1e-6) << name(situation) << " lane " << i << " t " << got.t[i];
      ASSERT_EQ(asked[i], got.pdf[i]) << name(situation) << " lane " << i;
    }
    report_quantiles(std::string("pdf_") + name(situation), errors);
  }
}

/// Trapezoids between places x = D sinh w from the foot, w in equal steps: close together where the density is high,
/// and far apart where it is low.
TEST_P(EquiangularAccuracy, TheDensityIntegratesToOne) {
  constexpr std::size_t steps = 4000, some = 10;
  for (const Situation situation : all_situations) {
    // In line D may be 0; passing through, steps of floats are no smaller than what they integrate over.
    if (situation == Situation::in_line || situation == Situation::through_pivot) continue;
    const SegmentArrays segments = make_segments(situation, pose(), some);
    std::vector<float> t;
    for (std::size_t j = 0; j <= steps; ++j) {
      for (std::size_t s = 0; s < some; ++s) {
        const reference::Equiangular exact(segments.segment(s), segments.pivot[s]);
        const double begin = std::asinh((segments.t_min[s] - exact.foot()) / exact.distance());
        const double end = std::asinh((segments.t_max[s] - exact.foot()) / exact.distance());
        const double w = begin + (end - begin) * static_cast<double>(j) / steps;
        const auto place = static_cast<float>(exact.foot() + exact.distance() * std::sinh(w));
        t.push_back(j == 0       ? segments.t_min[s]
                    : j == steps ? segments.t_max[s]
                                 : std::clamp(place, segments.t_min[s], segments.t_max[s]));
      }
    }
    const std::vector<float> density = pdf(segments, t);
    for (std::size_t s = 0; s < some; ++s) {
      double sum = 0;
      for (std::size_t to = some + s; to < t.size(); to += some) {
        const double mean = (static_cast<double>(density[to - some]) + static_cast<double>(density[to])) / 2;
        sum += mean * (static_cast<double>(t[to]) - static_cast<double>(t[to - some]));
      }
      EXPECT_NEAR(sum, 1, 1e-5) << name(situation) << " segment " << s;
    }
  }
}

TEST_P(EquiangularAccuracy, DistancesRiseWithTheVariate) {
  constexpr std::size_t steps = 1000;
  for (const Situation situation : all_situations) {
    const SegmentArrays segments = make_segments(situation, pose(), 50);
    std::vector<float> u;
    for (std::size_t j = 0; j <= steps; ++j) {
      u.insert(u.end(), 50, static_cast<float>(j) / static_cast<float>(steps));
    }
    const std::vector<float> t = sample(segments, u).t;
    for (std::size_t i = 50; i < t.size(); ++i) {
      ASSERT_GE(t[i], t[i - 50]) << name(situation) << " segment " << i % 50 << " u " << u[i];
    }
  }
}

/// What a camera ray that leaves the scene has. Half of it lies beyond the pivot's foot plus its distance, tan 45°.
TEST_P(EquiangularAccuracy, RaysWithoutEnd) {
  SegmentArrays segments = make_segments(Situation::ordinary, pose(), n);
  std::ranges::fill(segments.t_max, std::numeric_limits<float>::infinity());
  const std::vector<float> u = distribute(n);
  const DistanceArrays got = sample(segments, u);
  for (std::size_t i = 0; i < n; ++i) {
    reference::Segment whole = segments.segment(i);
    const reference::Equiangular exact(whole, segments.pivot[i]);
    const double wanted = std::min(u[i], 1 - 0x1p-24f);
    ASSERT_GT(got.pdf[i], 0) << "lane " << i;
    ASSERT_NEAR(exact.cdf(got.t[i]), wanted, 1e-5) << "lane " << i << " t " << got.t[i];
    ASSERT_NEAR(static_cast<double>(got.pdf[i]) / exact.density(got.t[i]), 1, 1e-5) << "lane " << i;
  }
}

/// The pivot on the segment itself: all distances are its own, to within an ulp, and none is spoilt.
TEST_P(EquiangularAccuracy, ThePivotOnTheSegment) {
  const Vec3 origin{0, 0, 0}, along{1, 0, 0};
  SegmentArrays segments;
  for (const float foot : {0.0f, 1e-20f, 1e-3f, 0.25f, 0.5f, 0.75f, 1.0f}) {
    segments.push_back({origin, along, 0, 1}, {foot, 0, 0});
  }
  const std::size_t count = segments.size();
  for (const float u : {0.01f, 0.3f, 0.5f, 0.7f, 0.99f}) {
    const DistanceArrays got = sample(segments, std::vector<float>(count, u));
    for (std::size_t i = 0; i < count; ++i) {
      const float foot = segments.pivot.x[i];
      ASSERT_GT(got.pdf[i], 0) << "foot " << foot << " u " << u;
      ASSERT_NEAR(got.t[i], foot, std::max(ulp(foot), 1e-7 * (i == 0)));
    }
  }
}

/// The same segment from its other end.
TEST_P(EquiangularAccuracy, TurnedRound) {
  SegmentArrays there = make_segments(Situation::ordinary, Pose::canonical, n), back;
  for (std::size_t i = 0; i < n; ++i) {
    const reference::Segment s = there.segment(i);
    back.push_back({{s.t_max, 0, 0}, {-1, 0, 0}, 0, s.t_max - s.t_min}, there.pivot[i]);
  }
  const std::vector<float> u = make_variates(n).u;
  std::vector<float> rest(n);
  std::ranges::transform(u, rest.begin(), [](float x) { return 1 - x; });
  const DistanceArrays forth = sample(there, u), round = sample(back, rest);
  for (std::size_t i = 0; i < n; ++i) {
    const float end = there.t_max[i];
    ASSERT_NEAR(end - round.t[i], forth.t[i], 1e-6f * end) << "segment " << i;
    ASSERT_NEAR(round.pdf[i] / forth.pdf[i], 1, 1e-5) << "segment " << i;
  }
}

HATBOX_FOR_EVERY_ISA_AND_POSE(EquiangularAccuracy);

}  // namespace
}  // namespace hatbox::test
