// From the repetitions of every case to medians, their ratios, a table and report.json.
#pragma once

#include <benchmark/benchmark.h>

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace hatbox::bench {

/// The map of a case that samples the lights of a set one by one.
inline constexpr const char* single_calls = "single_calls";

/// The workload of cases that are for plots: how cost grows. They run only if a filter asks for them.
inline constexpr const char* growth = "growth";

/// Points a call of the cases whose arrays stay in the cache.
inline constexpr std::size_t points_in_cache = 4096;

/// One case. The map "copy" (isa "any") copies the arrays; the isa "reference" is the scalar double reference.
struct Case {
  std::string light = {}, map = {}, isa = {}, workload = {};
  std::string reference_map = {};  // the reference's, if not called like the map
  int threads = 1;
  std::size_t samples_per_point = 1, points = 0;

  std::string name() const;
  std::size_t samples() const { return points * samples_per_point; }
};

/// Collects what Google Benchmark measures, a time for each repetition. Says on the terminal how far it is.
class Collector : public benchmark::BenchmarkReporter {
 public:
  explicit Collector(std::size_t expected_runs) : expected_runs_(expected_runs) {}

  bool ReportContext(const Context& context) override;
  void ReportRuns(const std::vector<Run>& runs) override;
  void Finalize() override;

  /// The median of the repetitions, nanoseconds a sample; 0 for a case that did not run.
  double ns_per_sample(const Case& c) const;

 private:
  std::size_t expected_runs_, done_runs_ = 0;
  std::map<std::string, std::vector<double>> seconds_;  // a call, by the name of the case
};

/// A way to compare two cases, nanoseconds a sample: this ÷ other, or other ÷ this where larger is better.
struct Comparison {
  const char* name;
  bool larger_is_better;
  bool (*fits)(const Case& measured, const Case& other);

  /// The first that fits; null if none does.
  const Case* other(const Case& measured, const std::vector<Case>& cases) const;
  /// 0 unless both did run.
  double ratio(const Case& measured, const Case& other, const Collector& collector) const;
};

/// All there are, in the order of a row's ratios.
std::span<const Comparison> comparisons();

/// A case and how it compares. A ratio is 0 where there is nothing to compare with.
struct Row {
  Case measured;
  double ns_per_sample = 0;
  std::vector<double> ratios = {};
};

std::vector<Row> compare(const std::vector<Case>& cases, const Collector& collector);
void print_table(const std::vector<Row>& rows);

/// One way to sample at one distance, in radii of the disk (distance_bench.h).
struct DistanceRow {
  double distance = 0, solid_angle = 0;  // the mean over all directions, steradians
  Case measured;
  double ns_per_sample = 0;
  double relative_error = 0;  // RMS, of the irradiance of a patch that faces the light, from 16 stratified samples
};

void write_json(const std::vector<Row>& rows, const std::vector<DistanceRow>& distances, const std::string& path);

}  // namespace hatbox::bench
