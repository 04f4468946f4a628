#include "soak/judge.h"

#include <cmath>
#include <cstdio>

namespace hatbox::test {
namespace {

/// What is wrong with a lane; null if nothing is.
const char* fault_of(const Sampler& sampler, const SampleArrays& samples, float density, std::size_t i) {
  for (const auto& column : samples.columns) {
    if (!std::isfinite(column[i])) return "an output is not finite";
  }
  if (!std::isfinite(density) || density < 0) return "pdf(direction) is no density";
  if (samples.at(SampleArrays::pdf, i) < 0) return "the pdf is negative";
  if (!samples.valid(i)) {
    for (const auto& column : samples.columns) {
      if (column[i] != 0) return "an invalid lane has an output that is not 0";
    }
    return nullptr;
  }
  if (std::abs(length(samples.direction(i)) - 1) > 1e-5) return "the direction is not of unit length";
  if (!(samples.at(SampleArrays::distance, i) >= 0)) return "the distance is negative";
  if (std::abs(samples.at(SampleArrays::cosine, i)) > 1 + 1e-6f) return "the cosine is beyond 1";
  const double s = samples.at(SampleArrays::s, i), t = samples.at(SampleArrays::t, i);
  if (sampler.outside && sampler.outside(s, t) > 1e-4) return "the place is outside of the light";
  return nullptr;
}

}  // namespace

void Judge::judge(const Sampler& sampler, const SampleArrays& samples, const std::vector<float>& densities,
                  const std::string& where) {
  Tally tally;
  std::size_t first_bad = 0;
  const char* fault = nullptr;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    ++tally.tried;
    tally.valid += samples.valid(i) ? 1u : 0u;
    const char* const found = fault_of(sampler, samples, densities[i], i);
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
  sum.tried += tally.tried;
  sum.valid += tally.valid;
  sum.failed += tally.failed;
}

Tally Judge::total() const {
  const std::lock_guard lock(mutex_);
  Tally total;
  for (const auto& [name, tally] : tallies_) {
    total.tried += tally.tried;
    total.valid += tally.valid;
    total.failed += tally.failed;
  }
  return total;
}

void Judge::print() const {
  std::printf("%-26s %14s %14s %10s\n", "light and map", "lanes", "of them valid", "failed");
  const auto row = [](const std::string& name, const Tally& tally) {
    std::printf("%-26s %14llu %14llu %10llu\n", name.c_str(), static_cast<unsigned long long>(tally.tried),
                static_cast<unsigned long long>(tally.valid), static_cast<unsigned long long>(tally.failed));
  };
  for (const auto& [name, tally] : tallies_) row(name, tally);
  row("all", total());
}

}  // namespace hatbox::test
