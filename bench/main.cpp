// hatbox_bench: what a sample costs. Repetitions of all cases are interleaved at random and compared by their medians,
// so that what else the machine does falls on all of them alike.
#include "carlson_bench.h"
#include "disk_bench.h"
#include "distance_bench.h"
#include "equiangular_bench.h"
#include "light_bench.h"
#include "light_set_bench.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <string>
#include <utility>
#include <vector>

namespace {

int run(int argc, char** argv) {
  using namespace hatbox::bench;
  CLI::App app{"Measures hatbox's samplers. Options of Google Benchmark (--benchmark_filter=…) are passed on."};
  std::string report;
  int repetitions = 5;
  double seconds = 0.02;
  app.add_option("--report", report, "Write the results to this JSON file");
  app.add_option("--repetitions", repetitions, "Interleaved runs of each case")->check(CLI::Range(1, 1000));
  app.add_option("--min-time", seconds, "Least seconds of a run");
  app.allow_extras();
  CLI11_PARSE(app, argc, argv);

  std::vector<std::string> options{argv[0], "--benchmark_enable_random_interleaving=true",
                                   "--benchmark_repetitions=" + std::to_string(repetitions),
                                   "--benchmark_min_time=" + std::to_string(seconds)};
  for (const std::string& extra : app.remaining()) options.push_back(extra);
  std::vector<char*> pointers;
  for (std::string& option : options) pointers.push_back(option.data());
  int count = static_cast<int>(pointers.size());
  benchmark::Initialize(&count, pointers.data());
  if (benchmark::ReportUnrecognizedArguments(count, pointers.data())) return 1;

  std::vector<Case> cases = register_disk_cases();
  for (Case& c : register_carlson_cases()) cases.push_back(std::move(c));
  for (Case& c : register_light_cases()) cases.push_back(std::move(c));
  for (Case& c : register_light_set_cases()) cases.push_back(std::move(c));
  for (Case& c : register_equiangular_cases()) cases.push_back(std::move(c));
  const std::vector<DistanceRow> distances = register_distance_cases();
  Collector collector((cases.size() + distances.size()) * static_cast<std::size_t>(repetitions));
  benchmark::RunSpecifiedBenchmarks(&collector);
  const std::vector<Row> rows = compare(cases, collector);
  print_table(rows);
  const std::vector<DistanceRow> over_distance = measure_distances(distances, collector);
  if (!report.empty()) write_json(rows, over_distance, report);
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
