#include "report.h"

#include <unistd.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace hatbox::bench {
namespace {

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The model's name, as the system tells it.
std::string cpu_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

}  // namespace

std::string Case::name() const {
  return light + "/" + map + "/" + isa + "/" + workload + "/threads:" + std::to_string(threads) +
         "/k:" + std::to_string(samples_per_point) + "/n:" + std::to_string(points);
}

bool Collector::ReportContext(const Context&) { return true; }

void Collector::ReportRuns(const std::vector<Run>& runs) {
  for (const Run& run : runs) {
    if (run.error_occurred) throw std::runtime_error(run.run_name.function_name + ": " + run.error_message);
    if (run.run_type != Run::RT_Iteration) continue;
    seconds_[run.run_name.function_name].push_back(run.real_accumulated_time / static_cast<double>(run.iterations));
    ++done_runs_;
  }
  if (isatty(STDERR_FILENO)) std::fprintf(stderr, "\r%zu of %zu runs", done_runs_, expected_runs_);
}

void Collector::Finalize() {
  if (isatty(STDERR_FILENO)) std::fprintf(stderr, "\r%*s\r", 40, "");
}

double Collector::ns_per_sample(const Case& c) const {
  const auto found = seconds_.find(c.name());
  return found == seconds_.end() ? 0 : median(found->second) * 1e9 / static_cast<double>(c.samples());
}

std::vector<Row> compare(const std::vector<Case>& cases, const Collector& collector) {
  std::vector<Row> rows;
  for (const Case& c : cases) {
    Row row{.measured = c, .ns_per_sample = collector.ns_per_sample(c)};
    if (row.ns_per_sample == 0) continue;
    for (const Comparison& comparison : comparisons()) {
      const Case* other = comparison.other(c, cases);
      row.ratios.push_back(other == nullptr ? 0 : comparison.ratio(c, *other, collector));
    }
    rows.push_back(row);
  }
  return rows;
}

void print_table(const std::vector<Row>& rows) {
  std::printf("%-11s %-16s %-10s %8s %4s %8s %12s", "light", "map", "isa", "threads", "k", "points", "ns/sample");
  for (const Comparison& comparison : comparisons()) std::printf(" %14s", comparison.name);
  std::printf("\n");
  for (const Row& row : rows) {
    const Case& c = row.measured;
    std::printf("%-11s %-16s %-10s %8d %4zu %8zu %12.3f", c.light.c_str(), c.map.c_str(), c.isa.c_str(), c.threads,
                c.samples_per_point, c.points, row.ns_per_sample);
    for (const double ratio : row.ratios) {
      if (ratio > 0) {
        std::printf(" %14.2f", ratio);
      } else {
        std::printf(" %14s", "");
      }
    }
    std::printf("\n");
  }
}

void write_json(const std::vector<Row>& rows, const std::vector<DistanceRow>& distances, const std::string& path) {
  nlohmann::ordered_json report{{"machine", cpu_name()}, {"rows", nlohmann::json::array()}};
  for (const Row& row : rows) {
    const Case& c = row.measured;
    report["rows"].push_back({{"light", c.light},
                              {"map", c.map},
                              {"isa", c.isa},
                              {"workload", c.workload},
                              {"threads", c.threads},
                              {"samples_per_point", c.samples_per_point},
                              {"points", c.points},
                              {"ns_per_sample", row.ns_per_sample}});
    std::size_t i = 0;
    for (const Comparison& comparison : comparisons()) report["rows"].back()[comparison.name] = row.ratios[i++];
  }
  report["distances"] = nlohmann::json::array();
  for (const DistanceRow& row : distances) {
    report["distances"].push_back({{"distance", row.distance},
                                   {"solid_angle", row.solid_angle},
                                   {"map", row.measured.map},
                                   {"isa", row.measured.isa},
                                   {"ns_per_sample", row.ns_per_sample},
                                   {"relative_error", row.relative_error}});
  }
  std::ofstream file(path);
  file << report.dump(1) << '\n';
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

}  // namespace hatbox::bench
