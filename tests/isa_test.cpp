// Which kernels run: chosen once, forced at will, and never by a name that means nothing here.
#include <gtest/gtest.h>
#include <hatbox/isa.h>

#include "dispatch.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <thread>

namespace hatbox {
namespace {

constexpr std::array every_isa{Isa::scalar, Isa::sse4_2, Isa::avx2, Isa::avx512, Isa::neon};

bool is_available(Isa isa) { return std::ranges::count(available_isas(), isa) == 1; }

template <class Call>
std::string message_of(Call call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no exception";
}

void expect_lists_what_there_is(const std::string& message) {
  for (const Isa isa : available_isas()) EXPECT_NE(message.find(name(isa)), std::string::npos) << message;
}

TEST(Isa, NamesAreThoseOfTheEnumerators) {
  EXPECT_STREQ(name(Isa::scalar), "scalar");
  EXPECT_STREQ(name(Isa::sse4_2), "sse4_2");
  EXPECT_STREQ(name(Isa::avx2), "avx2");
  EXPECT_STREQ(name(Isa::avx512), "avx512");
  EXPECT_STREQ(name(Isa::neon), "neon");
  EXPECT_STREQ(name(static_cast<Isa>(99)), "unknown");
}

TEST(Isa, ScalarIsAlwaysThereAndFirst) {
  ASSERT_FALSE(available_isas().empty());
  EXPECT_EQ(available_isas().front(), Isa::scalar);
}

TEST(Isa, TheBestIsChosenUnlessTheEnvironmentSaysOtherwise) {
  ASSERT_EQ(unsetenv("HATBOX_ISA"), 0);
  EXPECT_EQ(active_isa(), available_isas().back());
}

TEST(Isa, ForcedKernelsAreTheOnesThatRun) {
  for (const Isa isa : available_isas()) {
    force_isa(isa);
    EXPECT_EQ(active_isa(), isa);
    EXPECT_STREQ(active_kernels().isa, name(isa));
  }
}

TEST(Isa, LanesAreThoseOfTheVectors) {
  for (const Isa isa : available_isas()) {
    force_isa(isa);
    const std::size_t expected = isa == Isa::scalar ? 1 : isa == Isa::avx2 ? 8 : isa == Isa::avx512 ? 16 : 4;
    EXPECT_EQ(active_kernels().lanes, expected) << name(isa);
  }
}

TEST(Isa, ForcingWhatIsNotThereThrowsAndChangesNothing) {
  force_isa(Isa::scalar);
  for (const Isa isa : every_isa) {
    if (is_available(isa)) continue;
    expect_lists_what_there_is(message_of([&] { force_isa(isa); }));
    EXPECT_EQ(active_isa(), Isa::scalar);
  }
  expect_lists_what_there_is(message_of([] { force_isa(static_cast<Isa>(99)); }));
  EXPECT_EQ(active_isa(), Isa::scalar);
}

/// The choice is made once a process, so each of these looks at a process of its own.
class IsaEnvironment : public testing::Test {
 protected:
  void SetUp() override { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
};

TEST_F(IsaEnvironment, NamesTheKernels) {
  for (const Isa isa : available_isas()) {
    const auto names_it = [&] {
      setenv("HATBOX_ISA", name(isa), 1);
      std::exit(active_isa() == isa ? 0 : 1);
    };
    EXPECT_EXIT(names_it(), testing::ExitedWithCode(0), "") << name(isa);
  }
}

TEST_F(IsaEnvironment, EmptyIsAsGoodAsUnset) {
  const auto empty = [] {
    setenv("HATBOX_ISA", "", 1);
    std::exit(active_isa() == available_isas().back() ? 0 : 1);
  };
  EXPECT_EXIT(empty(), testing::ExitedWithCode(0), "");
}

TEST_F(IsaEnvironment, AWrongNameThrowsEveryTimeUntilMended) {
  const auto wrong_then_mended = [] {
    setenv("HATBOX_ISA", "mmx", 1);
    for (int i = 0; i < 2; ++i) {
      const std::string message = message_of([] { active_isa(); });
      EXPECT_NE(message.find("HATBOX_ISA"), std::string::npos) << message;
      EXPECT_NE(message.find("mmx"), std::string::npos) << message;
      expect_lists_what_there_is(message);
    }
    force_isa(Isa::scalar);
    EXPECT_EQ(active_isa(), Isa::scalar);
    std::exit(testing::Test::HasFailure() ? 1 : 0);
  };
  EXPECT_EXIT(wrong_then_mended(), testing::ExitedWithCode(0), "");
}

TEST(Isa, ForcingWhileOthersAskIsSafe) {
  std::atomic<bool> done{false};
  std::atomic<int> strangers{0};
  std::thread asker([&] {
    while (!done)
      if (!is_available(active_isa())) ++strangers;
  });
  for (int i = 0; i < 1000; ++i)
    for (const Isa isa : available_isas()) force_isa(isa);
  done = true;
  asker.join();
  EXPECT_EQ(strangers, 0);
}

}  // namespace
}  // namespace hatbox
