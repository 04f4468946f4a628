// The elliptic integrals against golden values: the bounds that include/hatbox/carlson.h states.
#include "support/carlson_calls.h"
#include "support/isa_fixture.h"
#include "support/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

namespace hatbox::test {
namespace {

/// Of the float nearest to a value.
double ulp_of(double value) { return std::ldexp(1.0, std::max(std::ilogb(value) - 23, -149)); }

double bound(Integral integral) {
  switch (integral) {
    case Integral::rj: return 16;
    case Integral::e: return 12;
    case Integral::pi: return 16;
    default: return 8;
  }
}

class Carlson : public IsaTest {
 protected:
  /// All rows of an integral in one call, so that lanes that end early share packets with those that do not.
  static void expect_golden(std::span<const GoldenIntegral> golden, Integral integral) {
    Columns columns;
    std::vector<double> expected;
    for (const GoldenIntegral& row : golden) {
      if (row.integral != integral) continue;
      for (std::size_t c = 0; c < columns.size(); ++c) columns[c].push_back(row.arguments[c]);
      expected.push_back(row.value);
    }
    std::vector<float> got(expected.size());
    call(integral, columns, got);
    std::vector<double> errors;
    for (std::size_t i = 0; i < got.size(); ++i) {
      errors.push_back(std::abs(static_cast<double>(got[i]) - expected[i]) / ulp_of(expected[i]));
      EXPECT_LE(errors.back(), bound(integral)) << name(integral) << " of " << columns[0][i] << ", " << columns[1][i]
                                                << ", " << columns[2][i] << ", " << columns[3][i] << ": " << got[i];
    }
    ASSERT_GT(errors.size(), 300u);
    report_quantiles(std::string("ulp_") + name(integral), errors);
  }
};

TEST_P(Carlson, SymmetricIntegralsAreGolden) {
  for (const Integral integral : {Integral::rf, Integral::rc, Integral::rd, Integral::rj}) {
    expect_golden(golden_carlson, integral);
  }
}

TEST_P(Carlson, LegendresIntegralsAreGolden) {
  for (const Integral integral : {Integral::f, Integral::e, Integral::pi}) expect_golden(golden_legendre, integral);
}

HATBOX_FOR_EVERY_ISA(Carlson);

}  // namespace
}  // namespace hatbox::test
