// The calls that have no light: distances along rays, elliptic integrals, instruction sets.
#include "fuzz/arrays.h"
#include "fuzz/targets.h"
#include "support/bits.h"
#include "support/carlson_calls.h"
#include "support/lane_faults.h"
#include "support/segments.h"

#include <hatbox/hatbox.h>

#include <array>
#include <cmath>
#include <deque>
#include <limits>

namespace hatbox::fuzz {
namespace {

using Out = std::vector<float>;

/// Segments and pivots, or planes, each array of which may have been bent.
struct SegmentInput {
  SegmentInput(Input& input, Arrays& arrays, std::size_t n) {
    for (auto& column : columns) column = &arrays.in(input.numbers(n));
  }
  Segments view() const {
    const auto& c = columns;
    return {*c[0], *c[1], *c[2], *c[3], *c[4], *c[5], *c[6], *c[7]};
  }
  Points place() const { return {*columns[8], *columns[9], *columns[10]}; }
  std::vector<float> lane(std::size_t i) const {
    std::vector<float> result;
    for (const auto* column : columns) result.push_back((*column)[i]);
    return result;
  }
  reference::Segment segment(std::size_t i) const {
    const auto& c = columns;
    return {{(*c[0])[i], (*c[1])[i], (*c[2])[i]}, {(*c[3])[i], (*c[4])[i], (*c[5])[i]}, (*c[6])[i], (*c[7])[i]};
  }

  std::array<const std::vector<float>*, 11> columns;
};

/// `numbers`: the lane's, to see what was asked.
void require_no_fault(const char* fault, const Manner& manner, const std::string& what,
                      const std::vector<float>& numbers) {
  if (fault != nullptr) require(false, what + ": " + fault + manner.told() + told(numbers));
}

bool in_range(float x) { return x >= 1e-30f && x <= 1e30f; }

/// What must hold of one of Carlson's integrals: NaN where an argument is less than -`least`, and none where all are in
/// range. Between -`least` and 0 they may count as 0.
const char* fault_of_integral(test::Integral integral, const std::array<float, 4>& arguments, std::size_t count,
                              float least, float value) {
  if (integral == test::Integral::f || integral == test::Integral::e || integral == test::Integral::pi) return nullptr;
  bool all_in_range = true, outside = false;
  for (std::size_t c = 0; c < count; ++c) {
    all_in_range = all_in_range && in_range(arguments[c]);
    outside = outside || !std::isfinite(arguments[c]) || arguments[c] < -least;
  }
  if (outside && !std::isnan(value)) return "outside of the domain there is a value";
  if (all_in_range && !(value >= 0)) return "inside the domain there is no value";
  return nullptr;
}

}  // namespace

void exercise_equiangular(Input& input, const Manner& manner) {
  constexpr std::size_t per_segment[] = {0, 1, 1, 3, 9};
  const std::size_t n = input.count();
  std::size_t numbers = n * per_segment[input.below(std::size(per_segment))];
  if (input.one_in(16)) numbers += input.below(n + 2);
  const bool uneven = n == 0 ? numbers != 0 : numbers % n != 0;
  Arrays arrays;
  const SegmentInput segments(input, arrays, n);
  std::vector<float> variates;
  for (std::size_t i = 0; i < numbers; ++i) variates.push_back(input.variate());
  const auto& u = arrays.in(variates);
  Out &t = arrays.out(numbers), &pdf = arrays.out(numbers), &asked = arrays.out(numbers);
  arrays.bend(input);
  const bool refused = uneven || arrays.refused();
  manner.run(refused, arrays.outputs(), "equiangular", [&] {
    // A bent array is one of both calls' or of one of them. The first to be called is to see it.
    if (asked.size() != numbers) return equiangular::pdf(segments.view(), segments.place(), u, asked);
    if (manner.grain) {
      parallel::equiangular::sample(segments.view(), segments.place(), u, t, pdf, *manner.grain);
      parallel::equiangular::pdf(segments.view(), segments.place(), t, asked, *manner.grain);
    } else {
      equiangular::sample(segments.view(), segments.place(), u, t, pdf);
      equiangular::pdf(segments.view(), segments.place(), t, asked);
    }
  });
  for (std::size_t i = 0; !refused && i < numbers; ++i) {
    std::vector<float> lane = segments.lane(i % n);
    lane.insert(lane.end(), {u[i], t[i], pdf[i], asked[i]});
    require_no_fault(test::fault_of_distance(segments.segment(i % n), t[i], pdf[i], asked[i]), manner, "equiangular",
                     lane);
  }
}

void exercise_clip(Input& input, const Manner& manner) {
  const std::size_t n = input.count();
  Arrays arrays;
  const SegmentInput segments(input, arrays, n);
  const auto &nx = arrays.in(input.numbers(n)), &ny = arrays.in(input.numbers(n)), &nz = arrays.in(input.numbers(n));
  Out &from = arrays.out(n), &to = arrays.out(n);
  arrays.bend(input);
  const bool refused = arrays.refused();
  manner.run(refused, arrays.outputs(), "clip", [&] {
    if (manner.grain) {
      parallel::equiangular::clip(segments.view(), segments.place(), {nx, ny, nz}, from, to, *manner.grain);
    } else {
      equiangular::clip(segments.view(), segments.place(), {nx, ny, nz}, from, to);
    }
  });
  for (std::size_t i = 0; !refused && i < n; ++i) {
    std::vector<float> lane = segments.lane(i);
    lane.insert(lane.end(), {nx[i], ny[i], nz[i], from[i], to[i]});
    require_no_fault(test::fault_of_clipped(segments.segment(i), from[i], to[i]), manner, "clip", lane);
  }
}

void exercise_carlson(Input& input, const Manner& manner) {
  const test::Integral integral = test::all_integrals[input.below(test::all_integrals.size())];
  const std::size_t n = input.count(), count = test::argument_names(integral).size();
  test::Columns columns;
  for (std::size_t c = 0; c < count; ++c) {
    for (std::size_t i = 0; i < n; ++i) {
      const float x = input.number();
      columns[c].push_back(input.one_in(8) ? x : std::abs(x));
    }
  }
  std::vector<float> out(n, test::SampleArrays::untouched);
  bool refused = false;
  if (input.one_in(6)) {
    std::vector<float>& bent = input.one_in(count + 1) ? out : columns[input.below(count)];
    bent = std::vector<float>(input.below(2 * n + 2), test::SampleArrays::untouched);
    refused = bent.size() != n;
  }
  const std::string what = std::string("carlson ") + test::name(integral);
  manner.run(refused, {&out}, what, [&] { test::call(integral, columns, out, manner.grain); });
  if (refused) return;
  // What is a normal float is none any more once it is scaled down.
  const float least = manner.flushing ? 0x1p-120f : std::numeric_limits<float>::min();
  for (std::size_t i = 0; i < n; ++i) {
    std::array<float, 4> arguments{};
    for (std::size_t c = 0; c < count; ++c) arguments[c] = columns[c][i];
    require_no_fault(fault_of_integral(integral, arguments, count, least, out[i]), manner, what,
                     {arguments[0], arguments[1], arguments[2], arguments[3], out[i]});
  }
}

void exercise_isa(Input& input, const Manner& manner) {
  const Isa isa = static_cast<Isa>(input.one_in(2) ? static_cast<int>(input.bits()) : static_cast<int>(input.below(6)));
  const auto all = available_isas();
  manner.run(std::ranges::find(all, isa) == all.end(), {}, "force_isa", [&] {
    force_isa(isa);
    require(active_isa() == isa, "another instruction set is active than was forced");
  });
  require(std::string(name(isa)).size() > 3, "an instruction set has no name");
}

}  // namespace hatbox::fuzz
