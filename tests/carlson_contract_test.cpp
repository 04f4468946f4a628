// What the elliptic integrals promise whatever their values: which arguments give NaN, same bits wherever an element
// lies and whatever lies beside it, and errors that name the span.
#include "support/bits.h"
#include "support/carlson_calls.h"
#include "support/isa_fixture.h"
#include "support/random.h"
#include "support/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>

namespace hatbox::test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float largest = std::numeric_limits<float>::max();
constexpr float quarter_turn = std::numbers::pi_v<float> / 2;

/// From cheap to slow: all decades of Carlson's arguments, every kind of Legendre's, some lanes outside the domain.
Columns mixed_arguments(Integral integral, std::size_t n) {
  const bool legendre = integral >= Integral::f;
  Random random(11);
  Columns columns;
  for (std::size_t i = 0; i < n; ++i) {
    for (auto& column : columns) {
      const double decades = i % 3 == 0 ? 30 : i % 3 == 1 ? 3 : 0.1;
      const auto value = static_cast<float>(std::pow(10, random.uniform(-decades, decades)));
      column.push_back(i % 31 == 7 ? -value : i % 17 == 3 ? 0 : value);
    }
    if (!legendre) continue;
    const auto phi = static_cast<float>(i % 2 ? random.uniform(-1.5, 1.5) : random.uniform(-100, 100));
    const auto m = static_cast<float>(i % 5 == 0 ? -random.log_uniform(1, 1e6) : random.uniform(0, 1));
    const auto n_of_pi = static_cast<float>(i % 4 == 0 ? -random.log_uniform(1e-3, 1e6) : random.uniform(0, 1));
    const bool has_n = integral == Integral::pi;
    columns[0][i] = has_n ? n_of_pi : phi;
    columns[1][i] = has_n ? phi : m;
    columns[2][i] = m;
  }
  return columns;
}

std::vector<float> called(Integral integral, const Columns& columns, std::optional<std::size_t> grain = {}) {
  std::vector<float> out(columns[0].size(), -1);
  call(integral, columns, out, grain);
  return out;
}

Columns picked(const Columns& all, const std::vector<std::size_t>& order) {
  Columns some;
  for (std::size_t c = 0; c < all.size(); ++c) {
    for (const std::size_t i : order) some[c].push_back(all[c][i]);
  }
  return some;
}

class CarlsonContract : public IsaTest {};

TEST_P(CarlsonContract, BitsDoNotDependOnPlaceOrNeighbours) {
  constexpr std::size_t n = 403;
  for (const Integral integral : all_integrals) {
    const Columns all = mixed_arguments(integral, n);
    const std::vector<float> expected = called(integral, all);
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto expect_same = [&] {
      const std::vector<float> got = called(integral, picked(all, order));
      for (std::size_t i = 0; i < order.size(); ++i) {
        ASSERT_TRUE(same_bits(got[i], expected[order[i]])) << name(integral) << " element " << order[i];
      }
    };
    std::reverse(order.begin(), order.end());
    expect_same();
    std::rotate(order.begin(), order.begin() + 5, order.end());
    expect_same();
    for (std::size_t i = 0; i < n; ++i) {  // alone
      order = {i};
      expect_same();
    }
    const std::size_t slowest = 0;
    for (std::size_t i = 0; i < n; ++i) {  // beside a slow one, and one outside the domain
      order = {slowest, i, 7};
      expect_same();
    }
  }
}

TEST_P(CarlsonContract, BitsDoNotDependOnThreads) {
  for (const Integral integral : all_integrals) {
    const Columns all = mixed_arguments(integral, 10007);
    const std::vector<float> expected = called(integral, all);
    for (const std::size_t grain : {std::size_t{0}, std::size_t{1}, std::size_t{100}, std::size_t{1} << 20}) {
      ASSERT_EQ(first_difference(called(integral, all, grain), expected), expected.size()) << name(integral);
    }
  }
}

TEST_P(CarlsonContract, EveryIsaHasTheSameBits) {
  const std::uint32_t allowed = GetParam() == Isa::sse4_2 ? 4 : 0;  // its fma differs once in some 10^8
  for (const Integral integral : all_integrals) {
    const Columns all = mixed_arguments(integral, 3001);
    const std::vector<float> got = called(integral, all);
    const ForcedIsa scalar(Isa::scalar);
    const std::vector<float> expected = called(integral, all);
    for (std::size_t i = 0; i < got.size(); ++i) {
      ASSERT_LE(ulp_distance(got[i], expected[i]), allowed) << name(integral) << " element " << i;
    }
  }
}

TEST_P(CarlsonContract, OutsideTheDomainIsNaN) {
  struct Case {
    Integral integral;
    std::array<float, 4> arguments;
  };
  std::vector<Case> cases{{Integral::rf, {0, 0, 1, 0}},
                          {Integral::rf, {1, 0, 0, 0}},
                          {Integral::rf, {0, 1, 0, 0}},
                          {Integral::rc, {1, 0, 0, 0}},
                          {Integral::rc, {1, -1, 0, 0}},
                          {Integral::rd, {0, 0, 1, 0}},
                          {Integral::rd, {1, 2, 0, 0}},
                          {Integral::rj, {0, 1, 0, 1}},
                          {Integral::rj, {1, 2, 3, 0}},
                          {Integral::rj, {1, 2, 3, -1}},
                          {Integral::f, {1, 2, 0, 0}},
                          {Integral::f, {2, 1.01f, 0, 0}},
                          {Integral::f, {2, 1, 0, 0}},
                          {Integral::f, {3.2f, 1.5f, 0, 0}},
                          {Integral::e, {1, 2, 0, 0}},
                          {Integral::e, {2, 1.01f, 0, 0}},
                          {Integral::e, {3.2f, 1.5f, 0, 0}},
                          {Integral::f, {2e6f, 0.5f, 0, 0}},
                          {Integral::pi, {0.5f, 1, 2, 0}},
                          {Integral::pi, {2, 1, 0.5f, 0}},
                          {Integral::pi, {1.5f, 3.2f, 0.5f, 0}},
                          {Integral::pi, {0.5f, 2, 1, 0}},
                          {Integral::pi, {1, 2, 0.5f, 0}},
                          {Integral::pi, {2, quarter_turn, 0.5f, 0}},
                          {Integral::pi, {0.5f, quarter_turn, 2, 0}}};
  for (const Integral integral : all_integrals) {
    const std::size_t count = argument_names(integral).size();
    for (std::size_t c = 0; c < count; ++c) {
      for (const float bad : {nan, infinity, -infinity}) {
        Case one{integral, {0.1f, 0.2f, 0.3f, 0.4f}};
        one.arguments[c] = bad;
        cases.push_back(one);
      }
      Case negative{integral, {0.1f, 0.2f, 0.3f, 0.4f}};
      negative.arguments[c] = -0.1f;
      if (integral < Integral::f) cases.push_back(negative);
    }
  }
  for (const auto& [integral, a] : cases) {
    EXPECT_TRUE(std::isnan(call(integral, a)))
        << name(integral) << " of " << a[0] << ", " << a[1] << ", " << a[2] << ", " << a[3];
  }
}

TEST_P(CarlsonContract, PolesAreInfinite) {
  EXPECT_EQ(call(Integral::f, {quarter_turn, 1, 0, 0}), infinity);
  EXPECT_EQ(call(Integral::f, {-quarter_turn, 1, 0, 0}), -infinity);
  for (const float n : {-2.0f, 0.0f, 0.5f, 1.0f}) EXPECT_EQ(call(Integral::pi, {n, quarter_turn, 1, 0}), infinity);
  for (const float m : {-2.0f, 0.0f, 0.5f, 1.0f}) EXPECT_EQ(call(Integral::pi, {1, -quarter_turn, m, 0}), -infinity);
  EXPECT_EQ(call(Integral::e, {quarter_turn, 1, 0, 0}), 1);
  EXPECT_EQ(call(Integral::e, {-quarter_turn, 1, 0, 0}), -1);
}

/// Arguments no bound is stated for still come to an end, with a number that can be one.
TEST_P(CarlsonContract, ExtremesEndAndArePositive) {
  const std::array<float, 9> extremes{0, 1e-44f, 1e-40f, 1.2e-38f, 1e-20f, 1, 1e20f, 1e38f, largest};
  Columns columns;
  for (const float x : extremes) {
    for (const float y : extremes) {
      for (const float z : extremes) {
        for (const float p : extremes) {
          columns[0].push_back(x), columns[1].push_back(y), columns[2].push_back(z), columns[3].push_back(p);
        }
      }
    }
  }
  for (const Integral integral : {Integral::rf, Integral::rc, Integral::rd, Integral::rj}) {
    const std::vector<float> got = called(integral, columns);
    for (std::size_t i = 0; i < got.size(); ++i) {
      std::array<float, 4> a{columns[0][i], columns[1][i], columns[2][i], columns[3][i]};
      if (integral == Integral::rc) a[2] = a[1];
      const int zeros = (a[0] == 0) + (a[1] == 0) + (a[2] == 0);
      const bool pole = (integral == Integral::rd && a[2] == 0) || (integral == Integral::rj && a[3] == 0);
      const bool inside = zeros < 2 && !pole;
      ASSERT_EQ(got[i] >= 0, inside) << name(integral) << " of " << a[0] << ", " << a[1] << ", " << a[2] << ", " << a[3]
                                     << ": " << got[i];
    }
  }
}

HATBOX_FOR_EVERY_ISA(CarlsonContract);

std::string complaint(Integral integral, const Columns& columns, std::span<float> out,
                      std::optional<std::size_t> grain) {
  try {
    call(integral, columns, out, grain);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(CarlsonErrors, SpansThatDisagreeAreNamed) {
  constexpr std::size_t n = 6;
  for (const Integral integral : all_integrals) {
    const std::vector<const char*> names = argument_names(integral);
    Columns good;
    for (auto& column : good) column.assign(n, 0.5f);
    for (const std::optional<std::size_t> grain : {std::optional<std::size_t>(), std::optional<std::size_t>(0)}) {
      std::vector<float> out(n, -1);
      EXPECT_EQ(complaint(integral, good, out, grain), "");
      EXPECT_NE(out[n - 1], -1);
      out.assign(n, -1);
      for (std::size_t c = 1; c < names.size(); ++c) {
        Columns bad = good;
        bad[c].resize(n - 1);
        const std::string message = complaint(integral, bad, out, grain);
        EXPECT_EQ(message, std::string(names[c]) + ": has 5 elements, expected 6");
      }
      EXPECT_EQ(complaint(integral, good, std::span(out).first(4), grain), "out: has 4 elements, expected 6");
      EXPECT_EQ(out, std::vector<float>(n, -1));
      EXPECT_EQ(complaint(integral, Columns{}, {}, grain), "");
    }
  }
}

}  // namespace
}  // namespace hatbox::test
