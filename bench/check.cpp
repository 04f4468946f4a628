#include "check.h"

#include <hatbox/isa.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <initializer_list>
#include <set>
#include <stdexcept>
#include <thread>

namespace hatbox::bench {
namespace {

using Json = nlohmann::json;

/// An entry of the file.
struct Check {
  Case measured = {}, other = {};
  const Comparison* comparison = nullptr;
  double need = 0, bound = 0;
  std::string skipped = {};     // why
  double best = 0;              // ratio so far
  double ns = 0, other_ns = 0;  // a sample, at that

  bool meets(double limit) const { return best > 0 && !better(limit, best); }
  bool better(double a, double b) const { return comparison->larger_is_better ? a > b : a < b; }
};

/// Takes the members of an object one by one, and in the end knows of any it was not asked for.
class Members {
 public:
  explicit Members(const Json& object) : object_(object) {
    if (!object.is_object()) throw std::runtime_error("not an object");
  }

  template <class T>
  T get(const char* key) {
    asked_.insert(key);
    if (!object_.contains(key)) throw std::runtime_error(std::string("\"") + key + "\" is missing");
    return value<T>(key);
  }

  template <class T>
  T get(const char* key, const T& otherwise) {
    asked_.insert(key);
    return object_.contains(key) ? value<T>(key) : otherwise;
  }

  void expect_no_others() const {
    for (const auto& [key, ignored] : object_.items()) {
      if (!asked_.contains(key)) throw std::runtime_error("unknown member \"" + key + "\"");
    }
  }

 private:
  template <class T>
  T value(const char* key) const {
    try {
      return object_.at(key).get<T>();
    } catch (const Json::exception&) {
      throw std::runtime_error(std::string("\"") + key + "\" has the wrong type");
    }
  }

  const Json& object_;
  std::set<std::string> asked_;
};

bool is_isa(const std::string& isa, std::initializer_list<Isa> all) {
  return std::any_of(all.begin(), all.end(), [&](Isa one) { return isa == name(one); });
}

/// What the machine lacks for a case; "" if nothing.
std::string lacking(const Case& c) {
  const auto available = available_isas();
  const bool is_here = std::any_of(available.begin(), available.end(), [&](Isa isa) { return c.isa == name(isa); });
  if (!is_here && is_isa(c.isa, {Isa::scalar, Isa::sse4_2, Isa::avx2, Isa::avx512, Isa::neon})) {
    return "no " + c.isa + " here";
  }
  const auto threads = static_cast<int>(std::thread::hardware_concurrency());
  return c.threads > threads ? "only " + std::to_string(threads) + " hardware threads" : "";
}

const Comparison& comparison_called(const std::string& name) {
  std::string known;
  for (const Comparison& one : comparisons()) {
    if (one.name == name) return one;
    known += std::string(known.empty() ? "" : ", ") + one.name;
  }
  throw std::runtime_error("unknown ratio \"" + name + "\", known are " + known);
}

void find_cases(Check& check, const std::vector<Case>& cases) {
  const std::string name = check.measured.name();
  const auto found = std::find_if(cases.begin(), cases.end(), [&](const Case& c) { return c.name() == name; });
  if (found == cases.end()) throw std::runtime_error("no such case: " + name);
  check.measured = *found;
  const Case* other = check.comparison->other(*found, cases);
  if (other == nullptr) throw std::runtime_error(name + " has no " + check.comparison->name);
  check.other = *other;
}

Check read_check(const Json& entry, const std::vector<Case>& cases) {
  Members members(entry);
  Check check{.measured = {.light = members.get<std::string>("light"),
                           .map = members.get<std::string>("map"),
                           .isa = members.get<std::string>("isa"),
                           .workload = members.get<std::string>("workload", "W1"),
                           .threads = members.get("threads", 1),
                           .samples_per_point = members.get("samples_per_point", std::size_t{1}),
                           .points = members.get("points", points_in_cache)},
              .comparison = &comparison_called(members.get<std::string>("ratio")),
              .need = members.get<double>("need"),
              .bound = members.get<double>("bound")};
  members.get<std::string>("note", "");
  members.expect_no_others();
  if (check.need <= 0 || check.bound <= 0) throw std::runtime_error("need and bound must be positive");
  if (check.better(check.bound, check.need)) throw std::runtime_error("the bound is stricter than the need");
  check.skipped = lacking(check.measured);
  if (check.skipped.empty()) find_cases(check, cases);
  return check;
}

Json parse(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot read it");
  try {
    return Json::parse(file);
  } catch (const Json::exception& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

std::vector<Check> read(const std::string& path, const std::vector<Case>& cases) {
  const Json file = parse(path);
  if (!file.is_object() || !file.contains("checks") || !file["checks"].is_array() || file["checks"].empty()) {
    throw std::runtime_error(path + ": must be an object with a list of \"checks\"");
  }
  std::vector<Check> checks;
  for (const Json& entry : file["checks"]) {
    try {
      checks.push_back(read_check(entry, cases));
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(path + ": checks[" + std::to_string(checks.size()) + "]: " + error.what());
    }
  }
  return checks;
}

/// Runs what these checks compare, interleaved, and keeps each one's best ratio.
void measure(const std::vector<Check*>& checks, int repetitions) {
  std::set<std::string> names;
  for (const Check* check : checks) {
    names.insert(check->measured.name());
    names.insert(check->other.name());
  }
  std::string filter;
  for (const std::string& name : names) filter += (filter.empty() ? "^(" : "|") + name;
  Collector collector(names.size() * static_cast<std::size_t>(repetitions));
  benchmark::RunSpecifiedBenchmarks(&collector, filter + ")/real_time");
  for (Check* check : checks) {
    const double ratio = check->comparison->ratio(check->measured, check->other, collector);
    if (ratio == 0) throw std::logic_error(check->measured.name() + " did not run");
    if (check->best != 0 && !check->better(ratio, check->best)) continue;
    check->best = ratio;
    check->ns = collector.ns_per_sample(check->measured);
    check->other_ns = collector.ns_per_sample(check->other);
  }
}

const char* verdict(const Check& check) {
  if (!check.skipped.empty()) return check.skipped.c_str();
  if (check.meets(check.need)) return "ok";
  if (!check.meets(check.bound)) return "FAIL";
  return check.comparison->larger_is_better ? "below need" : "above need";
}

void print(const std::vector<Check>& checks) {
  std::printf("%-9s %-10s %-7s %7s %3s %8s %9s  %-14s %9s %9s %8s %8s\n", "light", "map", "isa", "threads", "k",
              "points", "ns/sample", "ratio", "to ns", "measured", "bound", "need");
  for (const Check& check : checks) {
    const Case& c = check.measured;
    const char* sign = check.comparison->larger_is_better ? ">=" : "<=";
    std::printf("%-9s %-10s %-7s %7d %3zu %8zu %9.2f  %-14s %9.2f %9.2f %s %5.4g %s %5.4g  %s\n", c.light.c_str(),
                c.map.c_str(), c.isa.c_str(), c.threads, c.samples_per_point, c.points, check.ns,
                check.comparison->name, check.other_ns, check.best, sign, check.bound, sign, check.need,
                verdict(check));
  }
}

}  // namespace

bool check_baseline(const std::string& path, const std::vector<Case>& cases, int repetitions) {
  std::vector<Check> checks = read(path, cases);
  std::vector<Check*> to_measure;
  for (Check& check : checks) {
    if (check.skipped.empty()) to_measure.push_back(&check);
  }
  if (!to_measure.empty()) measure(to_measure, repetitions);
  for (Check* check : to_measure) {
    for (int again = 0; again < 2 && !check->meets(check->bound); ++again) measure({check}, repetitions);
  }
  print(checks);
  const auto failed = std::count_if(to_measure.begin(), to_measure.end(),
                                    [](const Check* check) { return !check->meets(check->bound); });
  const auto needy = std::count_if(to_measure.begin(), to_measure.end(),
                                   [](const Check* check) { return !check->meets(check->need); });
  std::printf("%zu checks: %td worse than their bounds, %td more that do not meet the need, %zu skipped\n",
              checks.size(), failed, needy - failed, checks.size() - to_measure.size());
  return failed == 0;
}

}  // namespace hatbox::bench
