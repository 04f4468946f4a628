#include "distance_bench.h"

#include "arrays.h"
#include "auto_switch.h"
#include "reference/irradiance.h"

#include <hatbox/hatbox.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <numeric>
#include <string>

namespace hatbox::bench {
namespace {

constexpr Disk light{{0, 0, 0}, {0, 0, 1}, 1};
constexpr std::size_t points = 4096;
constexpr double distances[] = {1.5, 2, 4, 8, 16, 32, 64, 128, 256, 1024, 1e5};
constexpr float switch_below = 1e-2f;  // steradians: within the range that production renderers use, its generous end

void sample(const std::string& map, const Points& at, const Variates& variates, const Samples& out) {
  if (map == "area") return hatbox::sample(light, DiskMap::area, at, variates, out);
  if (map == "ld_radial") return hatbox::sample(light, DiskMap::ld_radial, at, variates, out);
  sample_auto(light, switch_below, at, variates, out);
}

Arrays& arrays(double distance) {
  static std::map<double, std::unique_ptr<Arrays>> all;
  std::unique_ptr<Arrays>& one = all[distance];
  if (!one) one = std::make_unique<Arrays>(points, 1, distance);
  return *one;
}

double mean_solid_angle(double distance) {
  std::vector<float> omega(points);
  solid_angle(light, arrays(distance).points(), omega);
  return std::accumulate(omega.begin(), omega.end(), 0.0) / static_cast<double>(points);
}

/// A jittered 4 × 4 grid for each of n points, in the order of k·n arrays.
struct Stratified {
  explicit Stratified(std::size_t n) {
    Random random;
    for (int cell = 0; cell < 16; ++cell) {
      const int column = cell % 4, row = cell / 4;
      for (std::size_t i = 0; i < n; ++i) {
        u.push_back((static_cast<float>(column) + random(0, 1)) / 4);
        v.push_back((static_cast<float>(row) + random(0, 1)) / 4);
      }
    }
  }
  std::vector<float> u, v;
};

double relative_error(const std::string& map, double distance) {
  constexpr std::size_t n = 1024, k = 16;
  const Points all = arrays(distance).points();
  const Points at{all.x.first(n), all.y.first(n), all.z.first(n)};
  const Stratified variates(n);
  std::vector<float> x(k * n), y(k * n), z(k * n), far(k * n), pdf(k * n);
  sample(map, at, {variates.u, variates.v}, {x, y, z, far, pdf});
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 p{at.x[i], at.y[i], at.z[i]};
    const auto facing = reference::normalize(-1.0 * reference::convert<double>(p));
    double estimate = 0;
    for (std::size_t j = i; j < k * n; j += n) {
      const reference::Vector<double> direction{x[j], y[j], z[j]};
      if (pdf[j] > 0) estimate += std::max(dot(facing, direction), 0.0) / static_cast<double>(pdf[j]) / k;
    }
    const double error = estimate / reference::irradiance(light, p, facing) - 1;
    sum += error * error;
  }
  return std::sqrt(sum / n);
}

}  // namespace

std::vector<DistanceRow> register_distance_cases() {
  std::vector<DistanceRow> rows;
  for (const double distance : distances) {
    for (const char* map : {"area", "ld_radial", "auto"}) {
      char workload[32];
      std::snprintf(workload, sizeof workload, "distance_%g", distance);
      const Case c{
          .light = "disk", .map = map, .isa = name(available_isas().back()), .workload = workload, .points = points};
      benchmark::RegisterBenchmark(c.name().c_str(), [c, distance](benchmark::State& state) {
        Arrays& a = arrays(distance);
        force_isa(available_isas().back());
        for ([[maybe_unused]] auto _ : state) {
          sample(c.map, a.points(), a.variates(), a.samples());
          benchmark::ClobberMemory();
        }
      })->UseRealTime();
      rows.push_back({.distance = distance, .measured = c});
    }
  }
  return rows;
}

std::vector<DistanceRow> measure_distances(std::vector<DistanceRow> rows, const Collector& collector) {
  std::erase_if(rows, [&](const DistanceRow& row) { return collector.ns_per_sample(row.measured) == 0; });
  if (rows.empty()) return rows;
  std::printf("\n%8s %12s %-10s %12s %22s\n", "distance", "mean sr", "map", "ns/sample", "RMS error, 16 samples");
  for (DistanceRow& row : rows) {
    row.solid_angle = mean_solid_angle(row.distance);
    row.ns_per_sample = collector.ns_per_sample(row.measured);
    row.relative_error = relative_error(row.measured.map, row.distance);
    std::printf("%8g %12.3g %-10s %12.3f %22.3e\n", row.distance, row.solid_angle, row.measured.map.c_str(),
                row.ns_per_sample, row.relative_error);
  }
  return rows;
}

}  // namespace hatbox::bench
