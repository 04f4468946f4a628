// DiskTable: its arguments, its calls against each other, its own map in double, and how uniform it is.
#include "support/table_in_double.h"

#include "support/bits.h"
#include "support/isa_fixture.h"
#include "support/statistics.h"
#include "support/uniformity.h"

#include <hatbox/hatbox.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>

namespace hatbox::test {
namespace {

using reference::Vector;

constexpr DiskMap bases[] = {DiskMap::ld_radial, DiskMap::radial};

/// Made once for all tests.
const DiskTable& table_of(DiskMap base, std::size_t resolution) {
  static std::map<std::pair<DiskMap, std::size_t>, DiskTable> all;
  return all.try_emplace({base, resolution}, base, resolution).first->second;
}

std::string complaint(DiskMap base, std::size_t resolution) {
  try {
    const DiskTable table(base, resolution);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(DiskTableArguments, AreKept) {
  const DiskTable table(DiskMap::radial, 37);
  EXPECT_EQ(table.base(), DiskMap::radial);
  EXPECT_EQ(table.resolution(), 37u);
  EXPECT_EQ(DiskTable(DiskMap::ld_radial).resolution(), 1024u);
}

TEST(DiskTableArguments, OtherMapsAreRefused) {
  for (const DiskMap map : {DiskMap::area, static_cast<DiskMap>(99)}) {
    const std::string message = complaint(map, 64);
    EXPECT_NE(message.find("base"), std::string::npos) << message;
    EXPECT_NE(message.find(std::to_string(static_cast<int>(map))), std::string::npos) << message;
  }
}

TEST(DiskTableArguments, OtherResolutionsAreRefused) {
  for (const std::size_t resolution : {std::size_t{0}, std::size_t{3}, std::size_t{4097}, ~std::size_t{0}}) {
    const std::string message = complaint(DiskMap::ld_radial, resolution);
    EXPECT_NE(message.find("resolution"), std::string::npos) << message;
    EXPECT_NE(message.find(std::to_string(resolution)), std::string::npos) << message;
  }
  EXPECT_EQ(complaint(DiskMap::ld_radial, 4), "");
}

TEST(DiskTableArguments, BadLightsAndSpansAreRefused) {
  const DiskTable& table = table_of(DiskMap::ld_radial, 8);
  const PointArrays points = make_points(Workload::w1, Pose::canonical, 5);
  const VariateArrays variates = make_variates(5);
  SampleArrays samples(5);
  EXPECT_THROW(sample({{0, 0, 0}, {0, 0, 1}, 0}, table, points.view(), variates.view(), samples.view()),
               std::invalid_argument);
  EXPECT_THROW(sample(disk_in(Pose::canonical), table, points.view(), variates.view(0, 4), samples.view()),
               std::invalid_argument);
  EXPECT_EQ(samples.at(SampleArrays::x, 0), SampleArrays::untouched);
}

/// A copy needs no original, and what was moved from is still a table.
TEST(DiskTableArguments, CopiesLiveOn) {
  std::optional<DiskTable> original(DiskTable(DiskMap::ld_radial, 16));
  DiskTable moved_to(std::move(*original));
  const PointArrays points = make_points(Workload::w1, Pose::canonical, 50);
  const VariateArrays variates = make_variates(50);
  SampleArrays expected(50), got(50);
  sample(disk_in(Pose::canonical), *original, points.view(), variates.view(), expected.view());
  original.reset();
  sample(disk_in(Pose::canonical), moved_to, points.view(), variates.view(), got.view());
  for (std::size_t c = 0; c < got.columns.size(); ++c) {
    EXPECT_EQ(first_difference(got.columns[c], expected.columns[c]), 50u);
  }
}

class DiskTableCalls : public IsaAndPoseTest {
 protected:
  Disk light() const { return disk_in(pose()); }

  /// Calls `check(table, points, variates, samples)` for every base, several resolutions and numbers of samples.
  template <class Check>
  void for_every_sampling(Workload workload, Check check) const {
    for (const DiskMap base : bases) {
      for (const std::size_t resolution : {std::size_t{4}, std::size_t{8}, std::size_t{64}, std::size_t{1024}}) {
        const std::size_t k = resolution == 8 ? 3 : 1;
        const DiskTable& table = table_of(base, resolution);
        const PointArrays points = make_points(workload, pose(), 6000 / k);
        const VariateArrays variates = make_variates(k * points.size());
        SampleArrays samples(variates.size());
        sample(light(), table, points.view(), variates.view(), samples.view());
        SCOPED_TRACE(std::string(name(workload)) + " resolution " + std::to_string(resolution));
        check(table, points, variates, samples);
      }
    }
  }
};

/// Where the float direction still tells (u, v): not where u wraps around, and not where the centre hides it.
bool away_from_seam(DiskMap base, float u, float v) {
  return base != DiskMap::radial || (u > 0.001f && u < 0.999f && v > 0.01f);
}

TEST_P(DiskTableCalls, InvertUndoesSample) {
  for_every_sampling(Workload::w1, [&](const DiskTable& table, const PointArrays& points, const VariateArrays& variates,
                                       const SampleArrays& samples) {
    std::vector<float> u(samples.size()), v(samples.size());
    std::vector<double> errors;
    invert(light(), table, points.view(), samples.directions(), u, v);
    for (std::size_t i = 0; i < u.size(); ++i) {
      if (!away_from_seam(table.base(), variates.u[i], variates.v[i])) continue;
      errors.push_back(std::max(std::abs(u[i] - variates.u[i]), std::abs(v[i] - variates.v[i])));
    }
    report_quantiles("uv_error_" + std::to_string(table.resolution()), errors);
    EXPECT_LE(quantile(errors, 1), 1e-4);
  });
}

std::vector<double> relative_errors(const std::vector<float>& got, const std::vector<float>& expected) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < got.size(); ++i) errors.push_back(std::abs(got[i] / expected[i] - 1.0));
  return errors;
}

TEST_P(DiskTableCalls, PdfIsThatOfSample) {
  for_every_sampling(Workload::w1, [&](const DiskTable& table, const PointArrays& points, const VariateArrays&,
                                       const SampleArrays& samples) {
    std::vector<float> at_place(samples.size()), of_direction(samples.size());
    pdf(light(), table, points.view(), samples.places(), at_place);
    pdf(light(), table, points.view(), samples.directions(), of_direction);
    const auto of_sample = samples.columns[SampleArrays::pdf];
    EXPECT_LE(quantile(relative_errors(at_place, of_sample), 1), 1e-5);
    EXPECT_LE(quantile(relative_errors(of_direction, of_sample), 1), 1e-5);
  });
}

TEST_P(DiskTableCalls, NoSampleIsRejected) {
  for (const Workload workload : all_workloads) {
    for_every_sampling(workload, [&](const DiskTable& table, const PointArrays& points, const VariateArrays&,
                                     const SampleArrays& samples) {
      std::vector<float> at_place(samples.size());
      pdf(light(), table, points.view(), samples.places(), at_place);
      for (std::size_t i = 0; i < samples.size(); ++i) {
        ASSERT_TRUE(samples.valid(i)) << i;
        ASSERT_GT(at_place[i], 0) << i;
      }
    });
  }
}

/// What the table's map is in double, made once for all instruction sets.
template <template <class> class Map>
std::vector<Vector<double>> exact_directions(Pose pose, std::size_t resolution, const PointArrays& points,
                                             const VariateArrays& variates) {
  const TableInDouble table(pose, resolution);
  const auto light = table.light();
  std::vector<Vector<double>> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Map<double> map(light, points.x[i], points.y[i], points.z[i]);
    const auto exact = map.sample(variates.u[i], variates.v[i]);
    result.push_back({exact.direction[0], exact.direction[1], exact.direction[2]});
  }
  return result;
}

TEST_P(DiskTableCalls, DirectionsAreThoseOfTheTableInDouble) {
  constexpr std::size_t n = 20000;
  const PointArrays points = make_points(Workload::w1, pose(), n);
  const VariateArrays variates = make_variates(n);
  for (const std::size_t resolution : {std::size_t{8}, std::size_t{64}, std::size_t{1024}}) {
    for (const DiskMap base : bases) {
      static std::map<std::tuple<Pose, std::size_t, DiskMap>, std::vector<Vector<double>>> cases;
      auto& expected = cases[{pose(), resolution, base}];
      if (expected.empty()) {
        expected = base == DiskMap::radial
                       ? exact_directions<in_double::DiskTableRadial>(pose(), resolution, points, variates)
                       : exact_directions<in_double::DiskTableLdRadial>(pose(), resolution, points, variates);
      }
      SampleArrays samples(n);
      sample(light(), table_of(base, resolution), points.view(), variates.view(), samples.view());
      std::vector<double> errors;
      for (std::size_t i = 0; i < n; ++i) errors.push_back(angle_between(samples.direction(i), expected[i]));
      report_quantiles("radians_" + std::to_string(resolution), errors);
      EXPECT_LE(quantile(errors, 0.9999), 4e-6);
    }
  }
}

HATBOX_FOR_EVERY_ISA_AND_POSE(DiskTableCalls);

class DiskTableUniformitySlow : public IsaTest {};

/// As include/hatbox/disk_table.h says, but for tables smaller than it speaks of.
TEST_P(DiskTableUniformitySlow, DensityTimesSolidAngleIsNearlyOne) {
  for (const std::size_t resolution : {std::size_t{8}, std::size_t{64}, std::size_t{256}, std::size_t{1024}}) {
    const Sampler sampler("table", disk_in(Pose::canonical), table_of(DiskMap::ld_radial, resolution));
    const auto variations_in = [&](Workload workload) {
      return variations(sampler, make_points(workload, Pose::canonical, 4000), 16);
    };
    const auto w1 = variations_in(Workload::w1);
    const auto w2 = variations_in(Workload::w2);
    const auto w3 = variations_in(Workload::w3);
    report_quantiles("variation_W1_" + std::to_string(resolution), w1);
    report_quantiles("variation_W2_" + std::to_string(resolution), w2);
    report_quantiles("variation_W3_" + std::to_string(resolution), w3);
    EXPECT_LE(quantile(w1, 0.99), 5e-4);
    EXPECT_LE(quantile(w1, 0.999), 3e-3);
    EXPECT_LE(quantile(w2, 0.99), 2e-2);
    EXPECT_LE(quantile(w3, 1), 1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(Wide, DiskTableUniformitySlow, testing::ValuesIn(wide_isas()), isa_test_name);

}  // namespace
}  // namespace hatbox::test
