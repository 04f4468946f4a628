// Every instruction set gives what Isa::scalar gives, for every sampler and every call.
#include "support/all_samplers.h"
#include "support/isa_fixture.h"
#include "support/sampler_calls.h"
#include "support/statistics.h"

#include <gtest/gtest.h>

namespace hatbox::test {
namespace {

std::vector<double> ulp_distances(std::span<const float> a, std::span<const float> b) {
  std::vector<double> result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(ulp_distance(a[i], b[i]));
  return result;
}

std::vector<NamedColumn> scalar_outputs(const Sampler& sampler, const Queries& queries) {
  const ForcedIsa scalar(Isa::scalar);
  return call_everything(sampler, queries);
}

/// All but scalar.
class IsaAgreement : public IsaAndPoseTest {};

TEST_P(IsaAgreement, WithScalar) {
  for (const Workload workload : all_workloads) {
    const PointArrays points = make_points(workload, pose(), 3000);
    for (const Sampler& sampler : all_samplers(pose())) {
      for (const std::size_t k : sample_counts) {
        const std::string what = std::string(name(workload)) + "_" + sampler.name + "_k" + std::to_string(k);
        const Queries queries = make_queries(sampler, points, k);
        const auto got = call_everything(sampler, queries);
        const auto expected = scalar_outputs(sampler, queries);
        for (std::size_t i = 0; i < queries.size(); ++i) {
          const bool valid = got[SampleArrays::pdf].values[i] > 0;
          ASSERT_EQ(valid, expected[SampleArrays::pdf].values[i] > 0) << what << " lane " << i;
        }
        std::vector<double> all;
        for (std::size_t c = 0; c < got.size(); ++c) {
          const auto distances = ulp_distances(got[c].values, expected[c].values);
          all.insert(all.end(), distances.begin(), distances.end());
          if (workload != Workload::w1) continue;
          EXPECT_LE(quantile(distances, 0.999), 32) << what << " " << got[c].name;
        }
        report_quantiles("ulp_" + what, all);
        if (isa() != Isa::sse4_2) {  // whose fma is rounded twice
          EXPECT_EQ(quantile(all, 1), 0) << what;
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Every, IsaAgreement,
                         testing::Combine(testing::ValuesIn(available_isas().subspan(1)),
                                          testing::Values(Pose::canonical, Pose::general)),
                         isa_and_pose_name);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(IsaAgreement);

}  // namespace
}  // namespace hatbox::test
