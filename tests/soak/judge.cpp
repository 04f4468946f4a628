#include "soak/judge.h"

#include "support/lane_faults.h"

#include <cstdio>

namespace hatbox::test {

void Tally::operator+=(const Tally& other) {
  tried += other.tried;
  valid += other.valid;
  expected += other.expected;
  failed += other.failed;
}

void Judge::judge(const Sampler& sampler, const PointArrays& points, const std::vector<bool>& samplable,
                  const SampleArrays& samples, const std::vector<float>& densities, const std::string& where) {
  Tally tally;
  std::size_t first_bad = 0;
  const char* fault = nullptr;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    ++tally.tried;
    tally.valid += samples.valid(i) ? 1u : 0u;
    tally.expected += samplable[i] ? 1u : 0u;
    const char* found = fault_of(sampler, points[i], samples, i);
    if (found == nullptr) found = fault_of_density(densities[i]);
    if (found == nullptr && samplable[i] && !samples.valid(i)) found = "nothing was sampled";
    if (found == nullptr) continue;
    if (tally.failed++ == 0) {
      first_bad = i;
      fault = found;
    }
  }
  const std::lock_guard lock(mutex_);
  Tally& sum = tallies_[sampler.name];
  if (fault != nullptr && sum.failed < most_told) {
    std::fprintf(stderr, "soak: %s, %s, lane %zu: %s (and %llu more of this call)\n", sampler.name.c_str(),
                 where.c_str(), first_bad, fault, static_cast<unsigned long long>(tally.failed - 1));
  }
  sum += tally;
}

Tally Judge::total() const {
  const std::lock_guard lock(mutex_);
  Tally total;
  for (const auto& [name, tally] : tallies_) total += tally;
  return total;
}

void Judge::print() const {
  std::printf("%-26s %14s %14s %14s %10s\n", "light and map", "lanes", "of them valid", "expected to be", "failed");
  const auto row = [](const std::string& name, const Tally& tally) {
    std::printf("%-26s %14llu %14llu %14llu %10llu\n", name.c_str(), static_cast<unsigned long long>(tally.tried),
                static_cast<unsigned long long>(tally.valid), static_cast<unsigned long long>(tally.expected),
                static_cast<unsigned long long>(tally.failed));
  };
  for (const auto& [name, tally] : tallies_) row(name, tally);
  row("all", total());
}

}  // namespace hatbox::test
