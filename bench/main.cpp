// hatbox_bench: what a sample costs. Repetitions of all cases are interleaved at random and compared by their medians,
// so that what else the machine does falls on all of them alike.
#include "carlson_bench.h"
#include "check.h"
#include "disk_bench.h"
#include "distance_bench.h"
#include "equiangular_bench.h"
#include "growth_bench.h"
#include "light_bench.h"
#include "light_set_bench.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace hatbox::bench;

struct Options {
  std::string report, baseline;
  int repetitions = 5;
  double seconds = 0.02;
  std::vector<std::string> passed_on;
};

/// False for options that Google Benchmark does not know.
bool initialize(const char* program, const Options& options) {
  std::vector<std::string> words{program, "--benchmark_enable_random_interleaving=true",
                                 "--benchmark_repetitions=" + std::to_string(options.repetitions),
                                 "--benchmark_min_time=" + std::to_string(options.seconds)};
  words.insert(words.end(), options.passed_on.begin(), options.passed_on.end());
  std::vector<char*> pointers;
  pointers.reserve(words.size());
  for (std::string& word : words) pointers.push_back(word.data());
  int count = static_cast<int>(pointers.size());
  benchmark::Initialize(&count, pointers.data());
  return !benchmark::ReportUnrecognizedArguments(count, pointers.data());
}

std::vector<Case> register_all() {
  std::vector<Case> cases = register_disk_cases();
  for (const auto& more : {register_carlson_cases, register_light_cases, register_light_set_cases,
                           register_equiangular_cases, register_growth_cases}) {
    for (Case& c : more()) cases.push_back(std::move(c));
  }
  return cases;
}

void measure_all(const Options& options, std::vector<Case> cases) {
  const std::vector<DistanceRow> distances = register_distance_cases();
  std::string filter = benchmark::GetBenchmarkFilter();
  if (filter.empty()) {
    filter = std::string("-/") + growth + "/";
    std::erase_if(cases, [](const Case& c) { return c.workload == growth; });
  }
  Collector collector((cases.size() + distances.size()) * static_cast<std::size_t>(options.repetitions));
  benchmark::RunSpecifiedBenchmarks(&collector, filter);
  const std::vector<Row> rows = compare(cases, collector);
  print_table(rows);
  const std::vector<DistanceRow> over_distance = measure_distances(distances, collector);
  if (!options.report.empty()) write_json(rows, over_distance, options.report);
}

int run(int argc, char** argv) {
  Options options;
  CLI::App app{"Measures hatbox's samplers. Options of Google Benchmark (--benchmark_filter=…) are passed on."};
  auto* report = app.add_option("--report", options.report, "Write the results to this JSON file");
  auto* check = app.add_option("--check", options.baseline,
                               "Only see to it that the ratios of this JSON file are within their bounds");
  check->excludes(report);
  auto* repetitions =
      app.add_option("--repetitions", options.repetitions, "Interleaved runs of each case (5; with --check 15)")
          ->check(CLI::Range(1, 1000));
  app.add_option("--min-time", options.seconds, "Least seconds of a run");
  app.allow_extras();
  CLI11_PARSE(app, argc, argv);
  options.passed_on = app.remaining();
  if (*check && !*repetitions) options.repetitions = 15;

  if (!initialize(argv[0], options)) return 1;
  const std::vector<Case> cases = register_all();
  if (*check) return check_baseline(options.baseline, cases, options.repetitions) ? 0 : 1;
  measure_all(options, cases);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "hatbox_bench: %s\n", error.what());
    return 1;
  }
}
