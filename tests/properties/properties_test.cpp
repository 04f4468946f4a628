// Properties of every sampler over lights, points and variates that RapidCheck thinks of (cases.h), always the same
// ones. The rules are those of the public headers; what a property leaves out, and why, stands with it.
#include "properties/cases.h"
#include "support/bits.h"
#include "support/denormals.h"
#include "support/isa_fixture.h"
#include "support/lane_faults.h"
#include "support/sampler_calls.h"
#include "support/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace hatbox::test {
namespace {

class Properties : public IsaTest {
 protected:
  /// Tries a property, which fails by RC_FAIL, on a number of cases.
  template <class Property>
  static void hold(const rc::Gen<Case>& cases, int tries, const Property& property) {
    rc::detail::TestParams params;
    params.seed = 20260101;
    params.maxSuccess = tries;
    const auto result = rc::detail::checkTestable([&] { property(*cases); }, rc::detail::TestMetadata(), params);
    std::ostringstream message;
    rc::detail::printResultMessage(result, message);
    EXPECT_TRUE(result.template is<rc::detail::SuccessResult>()) << message.str();
  }
};

/// `sample` of a case, all outputs.
SampleArrays sampled(const Case& c) {
  SampleArrays result(c.size());
  c.sampler().sample(c.point_arrays().view(), c.variates(), result.view(), {});
  return result;
}

void fail(const Case& c, std::size_t lane, const std::string& what) {
  std::ostringstream message;
  message << what << ", lane " << lane << " of " << c;
  RC_FAIL(message.str());
}

void expect_no_fault(const Case& c, std::size_t lane, const char* fault) {
  if (fault != nullptr) fail(c, lane, fault);
}

/// The queries about what was sampled, and about the same directions and places from any other of the points.
Queries queries_of(const Case& c, const SampleArrays& samples, std::size_t shift) {
  Queries result;
  result.points = c.point_arrays();
  result.variates = {c.u, c.v};
  const auto column = [&](SampleArrays::Column which) {
    std::vector<float> values = samples.columns[which];
    std::rotate(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(shift % values.size()), values.end());
    return values;
  };
  result.x = column(SampleArrays::x);
  result.y = column(SampleArrays::y);
  result.z = column(SampleArrays::z);
  result.s = column(SampleArrays::s);
  result.t = column(SampleArrays::t);
  return result;
}

const std::vector<float>& column(const std::vector<NamedColumn>& columns, const std::string& name) {
  return std::ranges::find(columns, name, &NamedColumn::name)->values;
}

TEST_P(Properties, NoLaneBreaksTheRules) {
  hold(any_case(), 4000, [](const Case& c) {
    const Sampler sampler = c.sampler();
    for (const bool flushing : {false, true}) {
      SampleArrays samples(c.size());
      std::vector<NamedColumn> asked;
      {
        const FlushedDenormals flushed(flushing);
        samples = sampled(c);
        asked = call_everything(sampler, queries_of(c, samples, flushing ? 1 : 0));
      }
      for (std::size_t i = 0; i < c.size(); ++i) {
        expect_no_fault(c, i, fault_of(sampler, c.points[i], samples, i));
        expect_no_fault(c, i, fault_of_density(column(asked, "pdf_of_direction")[i]));
        expect_no_fault(c, i, fault_of_density(column(asked, "pdf_at_place")[i]));
        expect_no_fault(c, i, fault_of_solid_angle(column(asked, "solid_angle")[i]));
        if (sampler.invert) expect_no_fault(c, i, fault_of_inverse(column(asked, "u")[i], column(asked, "v")[i]));
      }
    }
  });
}

TEST_P(Properties, WhatOughtToBeSampledIs) {
  hold(any_case(), 4000, [](const Case& c) {
    const SampleArrays samples = sampled(c);
    for (std::size_t i = 0; i < c.size(); ++i) {
      if (c.samplable(i) && !samples.valid(i)) fail(c, i, "nothing was sampled");
    }
  });
}

/// Alone, in any place of an array, in blocks of a few points on several threads.
TEST_P(Properties, ALanesBitsAreItsOwn) {
  hold(any_case(), 1000, [](const Case& c) {
    const Sampler sampler = c.sampler();
    const Queries all = queries_of(c, sampled(c), 0);
    const auto expected = call_everything(sampler, all);
    const auto compare = [&](const std::vector<NamedColumn>& got, const std::vector<std::size_t>& order,
                             const char* how) {
      const auto wanted = pick(expected, c.size(), order);
      for (std::size_t which = 0; which < got.size(); ++which) {
        const std::size_t lane = first_difference(got[which].values, wanted[which].values);
        if (lane < order.size()) fail(c, order[lane], got[which].name + " has other bits " + how);
      }
    };
    std::vector<std::size_t> order(c.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::vector<std::size_t> many(150);  // enough for several blocks
    for (std::size_t i = 0; i < many.size(); ++i) many[i] = i % c.size();
    compare(call_everything(sampler, pick(all, many), 1), many, "in parallel");
    std::ranges::reverse(order);
    compare(call_everything(sampler, pick(all, order)), order, "elsewhere");
    for (std::size_t i = 0; i < c.size(); ++i) compare(call_everything(sampler, pick(all, {i})), {i}, "alone");
  });
}

/// Calls compare(case, lane, name, here, scalar) for every output of every lane.
template <class Compare>
void compare_with_scalar(const Case& c, const Compare& compare) {
  const Sampler sampler = c.sampler();
  const Queries queries = queries_of(c, sampled(c), 0);
  const auto here = call_everything(sampler, queries);
  const ForcedIsa scalar(Isa::scalar);
  const auto there = call_everything(sampler, queries);
  for (std::size_t which = 0; which < here.size(); ++which) {
    for (std::size_t i = 0; i < c.size(); ++i) {
      if (compare(here[which].name, here[which].values[i], there[which].values[i])) continue;
      fail(c, i, here[which].name + " is not as scalar's");
    }
  }
}

/// In every bit, but for sse4_2, whose fma is rounded twice once in some 10^8: that changes last places of gentle
/// lanes, and whatever it likes of hostile ones.
TEST_P(Properties, InstructionSetsAgree) {
  if (GetParam() != Isa::sse4_2) {
    hold(any_case(), 2000, [](const Case& c) {
      compare_with_scalar(c, [](const std::string&, float a, float b) { return same_bits(a, b); });
    });
    return;
  }
  hold(gentle_case(), 2000, [](const Case& c) {
    compare_with_scalar(c, [](const std::string& what, float a, float b) {
      const bool of_any_size = what == "distance" || what.starts_with("pdf") || what == "solid_angle";
      return std::abs(a - b) <= 4e-6f * (of_any_size ? std::abs(b) : 1);
    });
  });
}

/// Of all lanes that ought to be sampled, before and after, and whose numbers scale exactly. The density is rounded
/// anew.
TEST_P(Properties, PowersOfTwoScale) {
  hold(any_case(), 3000, [](const Case& c) {
    const int power = *rc::gen::inRange(-40, 41);
    const Case scaled = c.scaled(std::ldexp(1.0f, power));
    if (!scaled.is_light()) return;
    const Case back = scaled.scaled(std::ldexp(1.0f, -power));
    const SampleArrays here = sampled(c), there = sampled(scaled);
    for (std::size_t i = 0; i < c.size(); ++i) {
      if (!c.samplable(i) || !scaled.samplable(i) || !c.same_lane(back, i)) continue;
      for (std::size_t which = 0; which < SampleArrays::column_count; ++which) {
        const float a = here.columns[which][i], b = there.columns[which][i];
        const bool distance = which == SampleArrays::distance, rounded = distance || which == SampleArrays::pdf;
        const float same = distance ? std::ldexp(b, -power) : b;
        if (!same_bits(a, same) && !(rounded && std::abs(a / same - 1) <= 1e-6f)) {
          fail(c, i,
               std::string(name(static_cast<SampleArrays::Column>(which))) + " does not scale by 2^" +
                   std::to_string(power));
        }
      }
    }
  });
}

/// Axes exchanged and turned round: exact in float, so that solid angles differ by their own error alone, twice.
TEST_P(Properties, TurningTheWorldKeepsTheSolidAngle) {
  hold(gentle_case(), 3000, [](const Case& c) {
    const Case turned = c.turned();
    std::vector<float> here(c.size()), there(c.size());
    c.sampler().solid_angle(c.point_arrays().view(), here, {});
    turned.sampler().solid_angle(turned.point_arrays().view(), there, {});
    for (std::size_t i = 0; i < c.size(); ++i) {
      if (!(std::abs(here[i] / there[i] - 1) <= 4e-6f)) fail(c, i, "another solid angle");
    }
  });
}

/// The density of its place is that of a sample, wherever one ought to be.
TEST_P(Properties, PdfOfPlaceIsThatOfSample) {
  hold(any_case(), 4000, [](const Case& c) {
    const SampleArrays samples = sampled(c);
    std::vector<float> at_place(c.size());
    c.sampler().pdf_of_place(c.point_arrays().view(), samples.places(), at_place, {});
    for (std::size_t i = 0; i < c.size(); ++i) {
      if (!c.samplable(i)) continue;
      const double ratio = at_place[i] / static_cast<double>(samples.at(SampleArrays::pdf, i));
      if (!(std::abs(ratio - 1) <= 1e-5)) fail(c, i, "pdf of the place is " + std::to_string(ratio) + " of sample's");
    }
  });
}

/// Gentle lanes: elsewhere a float direction hides the place it leads to.
TEST_P(Properties, PdfOfDirectionIsThatOfSample) {
  hold(gentle_case(), 3000, [](const Case& c) {
    const SampleArrays samples = sampled(c);
    std::vector<float> density(c.size());
    c.sampler().pdf_of_direction(c.point_arrays().view(), samples.directions(), density, {});
    for (std::size_t i = 0; i < c.size(); ++i) {
      const double ratio = density[i] / static_cast<double>(samples.at(SampleArrays::pdf, i));
      if (!(std::abs(ratio - 1) <= 1e-5))
        fail(c, i, "pdf of the direction is " + std::to_string(ratio) + " of sample's");
    }
  });
}

/// Gentle lanes, clear of where a map winds about a point or tears: there a float direction does not tell (u, v).
TEST_P(Properties, InvertUndoesSample) {
  hold(gentle_case(), 3000, [](const Case& c) {
    const Sampler sampler = c.sampler();
    if (!sampler.invert) return;
    const SampleArrays samples = sampled(c);
    std::vector<float> u(c.size()), v(c.size());
    sampler.invert(c.point_arrays().view(), samples.directions(), u, v, {});
    for (std::size_t i = 0; i < c.size(); ++i) {
      if (!c.continuous_at(i)) continue;
      const float error = std::max(std::abs(u[i] - c.u[i]), std::abs(v[i] - c.v[i]));
      if (!(error <= 1e-4f)) fail(c, i, "the inverse is off by " + std::to_string(error));
    }
  });
}

/// Gentle lanes: elsewhere the headers allow the approximated maps more, and conditioning is in the solid angle.
TEST_P(Properties, DensityTimesSolidAngleIsOne) {
  hold(gentle_case(), 3000, [](const Case& c) {
    if (c.map_name() == "area") return;
    const SampleArrays samples = sampled(c);
    std::vector<float> omega(c.size());
    c.sampler().solid_angle(c.point_arrays().view(), omega, {});
    for (std::size_t i = 0; i < c.size(); ++i) {
      const double product = static_cast<double>(samples.at(SampleArrays::pdf, i)) * static_cast<double>(omega[i]);
      if (!(std::abs(product - 1) <= c.uniformity())) fail(c, i, "pdf times solid angle is " + std::to_string(product));
    }
  });
}

/// Arrays of any lengths: a call that is refused writes nothing, and no other is.
TEST_P(Properties, CallsAreRefusedAsAWhole) {
  hold(any_case(), 1000, [](const Case& c) {
    const auto length = [&] {
      return *rc::gen::element<std::size_t>(c.size(), c.size(), c.size(), 2 * c.size(), 0, 3);
    };
    const std::size_t points = length(), u = length(), v = length(), out = length();
    const std::vector<float> x(points, 0.5f), in_u(u, 0.5f), in_v(v, 0.5f);
    SampleArrays samples(out);
    const bool right = u == v && (points == 0 ? u == 0 : u % points == 0) && (out == u || out == 0);
    bool refused = false;
    try {
      c.sampler().sample({x, x, x}, {in_u, in_v}, samples.view(), {});
    } catch (const std::invalid_argument&) {
      refused = true;
    }
    if (refused == right) fail(c, 0, refused ? "a right call is refused" : "a wrong call is not refused");
    for (const auto& column : samples.columns) {
      for (std::size_t i = 0; i < out; ++i) {
        if ((column[i] == SampleArrays::untouched) != refused) fail(c, i, "written though refused, or not written");
      }
    }
  });
}

HATBOX_FOR_EVERY_ISA(Properties);

}  // namespace
}  // namespace hatbox::test
