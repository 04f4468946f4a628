// Fixtures that run a test once on every instruction set of this machine, and see to it that this one really ran.
#pragma once

#include "support/workloads.h"

#include <hatbox/isa.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <span>
#include <string>
#include <tuple>
#include <vector>

namespace hatbox::test {

/// Forces an instruction set and puts back the one that was active.
class ForcedIsa {
 public:
  explicit ForcedIsa(Isa isa) : before_(active_isa()) { force_isa(isa); }
  ~ForcedIsa() { force_isa(before_); }
  ForcedIsa(const ForcedIsa&) = delete;
  ForcedIsa& operator=(const ForcedIsa&) = delete;

 private:
  Isa before_;
};

class IsaTest : public testing::TestWithParam<Isa> {
 protected:
  void SetUp() override { ASSERT_EQ(active_isa(), GetParam()); }
  void TearDown() override { EXPECT_EQ(active_isa(), GetParam()) << "another ISA took over during the test"; }

 private:
  ForcedIsa forced_{GetParam()};
};

using IsaAndPose = std::tuple<Isa, Pose>;

/// Every ISA, with the light at the origin and in a general pose.
class IsaAndPoseTest : public testing::TestWithParam<IsaAndPose> {
 protected:
  Isa isa() const { return std::get<Isa>(GetParam()); }
  Pose pose() const { return std::get<Pose>(GetParam()); }
  void SetUp() override { ASSERT_EQ(active_isa(), isa()); }
  void TearDown() override { EXPECT_EQ(active_isa(), isa()) << "another ISA took over during the test"; }

 private:
  ForcedIsa forced_{std::get<Isa>(GetParam())};
};

/// The instruction sets that millions of samples are quick on: all but scalar and sse4_2, whose fused multiply-add is a
/// function call. Where there is no other, those.
inline std::vector<Isa> wide_isas() {
  const std::span<const Isa> all = available_isas();
  std::vector<Isa> wide;
  std::ranges::copy_if(all, std::back_inserter(wide), [](Isa isa) { return isa != Isa::scalar && isa != Isa::sse4_2; });
  return wide.empty() ? std::vector<Isa>(all.begin(), all.end()) : wide;
}

inline std::string isa_test_name(const testing::TestParamInfo<Isa>& info) { return name(info.param); }

inline std::string isa_and_pose_name(const testing::TestParamInfo<IsaAndPose>& info) {
  return std::string(name(std::get<Isa>(info.param))) + "_" + name(std::get<Pose>(info.param));
}

}  // namespace hatbox::test

#define HATBOX_FOR_EVERY_ISA(Suite)                                                                             \
  INSTANTIATE_TEST_SUITE_P(Every, Suite,                                                                        \
                           testing::ValuesIn(hatbox::available_isas().begin(), hatbox::available_isas().end()), \
                           hatbox::test::isa_test_name)

#define HATBOX_FOR_EVERY_ISA_AND_POSE(Suite)                                                                \
  INSTANTIATE_TEST_SUITE_P(                                                                                 \
      Every, Suite,                                                                                         \
      testing::Combine(testing::ValuesIn(hatbox::available_isas().begin(), hatbox::available_isas().end()), \
                       testing::Values(hatbox::test::Pose::canonical, hatbox::test::Pose::general)),        \
      hatbox::test::isa_and_pose_name)

// For statistics of millions of samples. What holds there holds on the others: isa_agreement_test.cpp.
#define HATBOX_FOR_WIDE_ISAS_AND_POSE(Suite)                                                         \
  INSTANTIATE_TEST_SUITE_P(                                                                          \
      Wide, Suite,                                                                                   \
      testing::Combine(testing::ValuesIn(hatbox::test::wide_isas()),                                 \
                       testing::Values(hatbox::test::Pose::canonical, hatbox::test::Pose::general)), \
      hatbox::test::isa_and_pose_name)
