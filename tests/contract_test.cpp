// What the library promises of every sampler, whatever it is given: no bad number, no place outside the light, bad
// lanes alone affected, nothing written but what was asked for. Its bits: independence_test.cpp.
#include "support/all_samplers.h"
#include "support/bits.h"
#include "support/isa_fixture.h"
#include "support/lane_faults.h"
#include "support/sampler_calls.h"

#include <hatbox/hatbox.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace hatbox::test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float last_below_one = 0x1.fffffep-1f;

/// Every instruction set, the lights at the origin and in a general pose.
class Contract : public IsaAndPoseTest {
 protected:
  /// Where shading points may be, and where they had better not: around the disk, then out of all bounds.
  PointArrays adversarial_points() const {
    PointArrays points;
    for (const double x : {0.0, 0.5, 1.0, 2.0, 1 - 1e-7, 1 + 1e-7, 0x1p20, 0x1p-20, 1e-30}) {
      for (const double z : {0.0, 1e-30, -1e-30, 3e-23, 1e-22, 1e-7, -1e-4, 1.0, 0x1p20, -0x1p-20, 1e18}) {
        points.push_back(moved(pose(), {x, 0, z}));
        points.push_back(moved(pose(), {-0.6 * x, 0.8 * x, z}));
      }
    }
    for (const float bad : {nan, infinity, -infinity, std::numeric_limits<float>::max()}) {
      points.push_back({bad, 0, 1});
      points.push_back({0, bad, 1});
      points.push_back({0, 0, bad});
      points.push_back({bad, bad, bad});
    }
    return points;
  }
};

void expect_sane(const Sampler& sampler, const Vec3& point, const SampleArrays& samples, std::size_t i) {
  const char* const fault = fault_of(sampler, point, samples, i);
  ASSERT_EQ(fault, nullptr) << "lane " << i << ": " << fault;
}

TEST_P(Contract, NoBadNumbersFromBadPlaces) {
  const PointArrays points = adversarial_points();
  const std::size_t n = points.size();
  for (const Sampler& sampler : all_samplers(pose())) {
    SCOPED_TRACE(sampler.name);
    for (const float u : {0.0f, 0.3f, 0.5f, last_below_one, 1.0f}) {
      for (const float v : {0.0f, 0.5f, 0.7f, last_below_one, 1.0f}) {
        const VariateArrays variates{std::vector<float>(n, u), std::vector<float>(n, v)};
        SampleArrays samples(n);
        sampler.sample(points.view(), variates.view(), samples.view(), {});
        for (std::size_t i = 0; i < n; ++i) expect_sane(sampler, points[i], samples, i);
        Queries queries{.points = points,
                        .variates = variates,
                        .x = samples.columns[SampleArrays::x],
                        .y = samples.columns[SampleArrays::y],
                        .z = samples.columns[SampleArrays::z],
                        .s = samples.columns[SampleArrays::s],
                        .t = samples.columns[SampleArrays::t]};
        for (const auto& [what, values] : call_everything(sampler, queries)) {
          const float least = what == "u" || what == "v" || what.size() <= 2 || what == "cosine" ? -1.000001f : 0.0f;
          for (const float value : values) ASSERT_TRUE(std::isfinite(value) && value >= least) << what << " " << value;
        }
      }
    }
  }
}

/// The density at its own place is never 0, wherever a sample could be taken.
TEST_P(Contract, NoSampleIsOffItsPlace) {
  const PointArrays points = adversarial_points();
  for (const Sampler& sampler : all_samplers(pose())) {
    SCOPED_TRACE(sampler.name);
    for (const std::size_t k : sample_counts) {
      const VariateArrays variates = make_variates(k * points.size());
      SampleArrays samples(variates.size());
      std::vector<float> at_place(variates.size());
      sampler.sample(points.view(), variates.view(), samples.view(), {});
      sampler.pdf_of_place(points.view(), samples.places(), at_place, {});
      for (std::size_t i = 0; i < samples.size(); ++i) {
        ASSERT_EQ(at_place[i] > 0, samples.valid(i)) << "point " << i % points.size();
      }
    }
  }
}

TEST_P(Contract, NothingIsSampledFromNowhere) {
  PointArrays points;
  for (const float bad : {nan, infinity, -infinity}) {
    points.push_back({bad, 0, 1});
    points.push_back({0, bad, 1});
    points.push_back({0, 0, bad});
  }
  if (pose() == Pose::canonical) {  // only here do floats hit the plane exactly
    for (const float x : {0.0f, 0.5f, 1.0f, 2.0f, 1e20f}) points.push_back({x, 0, 0});
  }
  for (const Sampler& sampler : all_samplers(pose())) {
    SCOPED_TRACE(sampler.name);
    Queries queries = make_queries(sampler, points, 3);
    queries.z.assign(queries.size(), -1);
    for (const auto& [what, values] : call_everything(sampler, queries)) {
      for (const float value : values) EXPECT_EQ(value, what == "u" || what == "v" ? -1 : 0) << what;
    }
  }
}

TEST_P(Contract, VariatesAreClamped) {
  constexpr std::size_t n = 8;
  const PointArrays points = repeat(moved(pose(), {0.3, 0.4, 0.5}), n);
  const std::vector<float> given{1.0f, 7.0f, -0.0f, -3.0f, last_below_one, 0.0f, 3e38f, -3e38f};
  const std::vector<float> clamped{last_below_one, last_below_one, 0, 0, last_below_one, 0, last_below_one, 0};
  const std::vector<float> other(n, 0.3f);
  for (const Sampler& sampler : all_samplers(pose())) {
    SCOPED_TRACE(sampler.name);
    const Variates pairs[][2] = {
        {{given, other}, {clamped, other}}, {{other, given}, {other, clamped}}, {{given, given}, {clamped, clamped}}};
    for (const auto& pair : pairs) {
      SampleArrays a(n), b(n);
      sampler.sample(points.view(), pair[0], a.view(), {});
      sampler.sample(points.view(), pair[1], b.view(), {});
      for (std::size_t i = 0; i < n; ++i) EXPECT_TRUE(a.valid(i)) << given[i];
      for (std::size_t c = 0; c < a.columns.size(); ++c) EXPECT_EQ(first_difference(a.columns[c], b.columns[c]), n);
    }
  }
}

/// A lane with a bad point or variate gives 0, and no other lane can tell.
TEST_P(Contract, BadLanesAloneAreAffected) {
  constexpr std::size_t n = 101;
  for (const Sampler& sampler : all_samplers(pose())) {
    SCOPED_TRACE(sampler.name);
    for (const std::size_t k : sample_counts) {
      const Queries good = make_queries(sampler, make_points(Workload::w1, pose(), n), k);
      Queries spoiled = good;
      const auto bad_point = [](std::size_t i) { return i % 7 == 3; };
      const auto bad_variate = [](std::size_t i) { return i % 5 == 2; };
      for (std::size_t i = 0; i < n; ++i) {
        constexpr float bad_values[] = {infinity, nan};
        if (bad_point(i)) spoiled.points.y[i] = bad_values[i % 2];
      }
      for (std::size_t i = 0; i < good.size(); ++i) {
        if (bad_variate(i)) (i % 2 ? spoiled.variates.u : spoiled.variates.v)[i] = i % 3 ? nan : -infinity;
      }
      const auto expected = call_everything(sampler, good);
      const auto got = call_everything(sampler, spoiled);
      for (std::size_t c = 0; c < got.size(); ++c) {
        const bool sampled = c < SampleArrays::column_count;
        const bool inverse = got[c].name == "u" || got[c].name == "v";
        for (std::size_t i = 0; i < got[c].values.size(); ++i) {
          const bool bad = bad_point(i % n) || (sampled && bad_variate(i));
          const float want = !bad ? expected[c].values[i] : inverse ? -1.0f : 0.0f;
          ASSERT_TRUE(same_bits(got[c].values[i], want)) << got[c].name << " lane " << i << " " << got[c].values[i];
        }
      }
    }
  }
}

/// No absolute epsilon: a power of two scales the distance and nothing else (but the rounding of the density).
TEST_P(Contract, ScaleDoesNotMatter) {
  for (const Workload workload : all_workloads) {
    const PointArrays points = make_points(workload, pose(), 500);
    const VariateArrays variates = make_variates(points.size());
    const std::vector<Sampler> samplers = all_samplers(pose());
    for (const float scale : {0x1p20f, 0x1p-20f}) {
      PointArrays scaled_points = points;
      for (auto* coordinates : {&scaled_points.x, &scaled_points.y, &scaled_points.z}) {
        for (float& coordinate : *coordinates) coordinate *= scale;
      }
      const std::vector<Sampler> scaled_samplers = all_samplers(pose(), scale);
      for (std::size_t m = 0; m < samplers.size(); ++m) {
        SampleArrays here(variates.size()), there(variates.size());
        samplers[m].sample(points.view(), variates.view(), here.view(), {});
        scaled_samplers[m].sample(scaled_points.view(), variates.view(), there.view(), {});
        for (float& distance : there.columns[SampleArrays::distance]) distance /= scale;
        for (std::size_t c = 0; c < SampleArrays::column_count; ++c) {
          for (std::size_t i = 0; i < here.size(); ++i) {
            const float a = here.columns[c][i], b = there.columns[c][i];
            const bool rounded = c == SampleArrays::distance || c == SampleArrays::pdf;
            ASSERT_TRUE(same_bits(a, b) || (rounded && std::abs(a / b - 1) < 1e-6f))
                << name(workload) << " " << samplers[m].name << " " << name(static_cast<SampleArrays::Column>(c));
          }
        }
      }
    }
  }
}

/// Arrays that start anywhere, and neighbours on both sides that are nobody's business.
TEST_P(Contract, WritesItsSpansAndNoMore) {
  constexpr std::size_t margin = 19;
  for (const Sampler& sampler : all_samplers(pose())) {
    SCOPED_TRACE(sampler.name);
    for (const std::size_t n : odd_sizes) {
      for (const std::size_t k : sample_counts) {
        const PointArrays points = make_points(Workload::w1, pose(), n + 1);
        const VariateArrays variates = make_variates(k * n + 1);
        SampleArrays samples(k * n + 2 * margin);
        sampler.sample(points.view(1, n), variates.view(1, k * n), samples.view(margin, k * n), {});
        for (const auto& column : samples.columns) {
          for (std::size_t i = 0; i < column.size(); ++i) {
            const bool ours = i >= margin && i < margin + k * n;
            ASSERT_EQ(column[i] != SampleArrays::untouched, ours) << "n " << n << " k " << k << " at " << i;
          }
        }
      }
    }
  }
}

TEST_P(Contract, OutputsAreOptional) {
  constexpr std::size_t n = 37;
  const PointArrays points = make_points(Workload::w1, pose(), n);
  for (const Sampler& sampler : all_samplers(pose())) {
    SCOPED_TRACE(sampler.name);
    for (const std::size_t k : sample_counts) {
      const VariateArrays variates = make_variates(k * n);
      SampleArrays all(k * n);
      sampler.sample(points.view(), variates.view(), all.view(), {});
      for (unsigned wanted = 0; wanted < 1u << SampleArrays::column_count; ++wanted) {
        SampleArrays some(k * n);
        Samples out = some.view();
        std::span<float>* const spans[] = {&out.x,   &out.y, &out.z, &out.distance,
                                           &out.pdf, &out.s, &out.t, &out.cosine};
        for (std::size_t c = 0; c < std::size(spans); ++c) {
          if (!(wanted >> c & 1)) *spans[c] = {};
        }
        sampler.sample(points.view(), variates.view(), out, {});
        for (std::size_t c = 0; c < std::size(spans); ++c) {
          const std::vector<float> untouched(k * n, SampleArrays::untouched);
          const auto& want = wanted >> c & 1 ? all.columns[c] : untouched;
          ASSERT_EQ(first_difference(some.columns[c], want), k * n) << "outputs " << wanted << " column " << c;
        }
      }
    }
  }
}

HATBOX_FOR_EVERY_ISA_AND_POSE(Contract);

}  // namespace
}  // namespace hatbox::test
