// What the report and the check compare a case with.
#include "report.h"

#include <algorithm>

namespace hatbox::bench {
namespace {

/// The same arrays, threads and light, whatever is done with them.
bool same_call(const Case& a, const Case& b) {
  return a.light == b.light && a.workload == b.workload && a.threads == b.threads &&
         a.samples_per_point == b.samples_per_point && a.points == b.points;
}

bool vs_area(const Case& c, const Case& other) {
  return other.map == "area" && other.isa == c.isa && same_call(c, other);
}

bool vs_copy(const Case& c, const Case& other) { return other.map == "copy" && same_call(c, other); }

/// The scalar reference of the map, which need not be in double: see light_bench.cpp.
bool vs_reference(const Case& c, const Case& other) {
  const bool same_map = other.map == (c.reference_map.empty() ? c.map : c.reference_map);
  return other.isa == "reference" && other.light == c.light && other.workload == c.workload && same_map &&
         (c.reference_map.empty() || other.samples_per_point == c.samples_per_point);
}

/// The paper's tabulated map in scalar double, whatever map this one is.
bool vs_paper_table(const Case& c, const Case& other) {
  return other.map == "paper_table" && other.light == c.light && other.workload == c.workload &&
         other.samples_per_point == c.samples_per_point && c.isa != "reference" && c.map != "copy" && c.map != "area";
}

/// Of a set: calls for its lights, or for 64 of them, one by one.
bool vs_single(const Case& c, const Case& other) {
  return other.map == single_calls && c.map == "best" && c.isa == other.isa && c.workload == other.workload &&
         c.samples_per_point == other.samples_per_point && (c.light == other.light || other.light == "set_64");
}

bool same_kernel(const Case& c, const Case& other) {
  return c.light == other.light && c.map == other.map && c.isa == other.isa && c.workload == other.workload &&
         c.samples_per_point == other.samples_per_point;
}

/// Of a call for few points: one for thousands.
bool vs_large(const Case& c, const Case& other) {
  return same_kernel(c, other) && c.threads == other.threads && c.points == 16 && other.points == points_in_cache;
}

/// Of several threads: one.
bool speedup(const Case& c, const Case& other) {
  return same_kernel(c, other) && c.points == other.points && c.threads > 1 && other.threads == 1;
}

constexpr Comparison all[] = {{"vs_area", false, vs_area},
                              {"vs_copy", false, vs_copy},
                              {"vs_reference", true, vs_reference},
                              {"vs_paper_table", true, vs_paper_table},
                              {"vs_single", false, vs_single},
                              {"vs_large", false, vs_large},
                              {"speedup", true, speedup}};

}  // namespace

std::span<const Comparison> comparisons() { return all; }

const Case* Comparison::other(const Case& measured, const std::vector<Case>& cases) const {
  const auto found = std::find_if(cases.begin(), cases.end(), [&](const Case& c) { return fits(measured, c); });
  return found == cases.end() ? nullptr : &*found;
}

double Comparison::ratio(const Case& measured, const Case& other, const Collector& collector) const {
  const double mine = collector.ns_per_sample(measured), its = collector.ns_per_sample(other);
  if (mine == 0 || its == 0) return 0;
  return larger_is_better ? its / mine : mine / its;
}

}  // namespace hatbox::bench
