// The errors that the angles of equiangular sampling are stated to have, in the kernels' own text.
#define HATBOX_ISA trig_test
#include "equiangular_map.h"
#include "support/random.h"
#include "support/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hatbox::trig_test {
namespace {

double error_in_ulp(float got, double expected) {
  return std::abs(static_cast<double>(got) - expected) / test::ulp(static_cast<float>(expected));
}

TEST(Trig, SineOfAnAcuteAngle) {
  test::Random random(1);
  double worst = 0;
  for (int i = 0; i < 300000; ++i) {
    const auto x = static_cast<float>(i % 2 ? random.uniform(0, pi / 2) : random.log_uniform(1e-30, pi / 2));
    worst = std::max(worst, error_in_ulp(sin_of_acute(x), std::sin(static_cast<double>(x))));
  }
  worst = std::max(worst, error_in_ulp(sin_of_acute(static_cast<float>(pi / 2) + 4e-7f), 1));
  EXPECT_LE(worst, 2);
  EXPECT_EQ(sin_of_acute(0.0f), 0);
}

TEST(Trig, AcuteAngleAndItsComplement) {
  test::Random random(2);
  double worst = 0;
  for (int i = 0; i < 300000; ++i) {
    const auto y = static_cast<float>(random.log_uniform(1e-8, 1e8)), x = static_cast<float>(random.uniform(0.01, 100));
    const AcuteAngle<float> got(y, x);
    worst = std::max({worst, error_in_ulp(got.angle, std::atan2(static_cast<double>(y), static_cast<double>(x))),
                      error_in_ulp(got.complement, std::atan2(static_cast<double>(x), static_cast<double>(y)))});
  }
  EXPECT_LE(worst, 4);
}

}  // namespace
}  // namespace hatbox::trig_test
