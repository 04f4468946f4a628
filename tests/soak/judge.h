// Counts of lanes by what must hold of each (lane_faults.h), and of those that ought to be sampled (samplable.h).
#pragma once

#include "support/sampler.h"
#include "support/workloads.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>

namespace hatbox::test {

/// Of one sampler, or of all.
struct Tally {
  std::uint64_t tried = 0, valid = 0;
  std::uint64_t expected = 0;  // ought to be valid
  std::uint64_t failed = 0;    // of all: a fault, or 0 where a sample is expected

  void operator+=(const Tally& other);
};

/// Collects verdicts from all threads; tells the first failures.
class Judge {
 public:
  /// What was sampled from points, and the densities of its directions. `where` is for the message, with the lane
  /// behind it.
  void judge(const Sampler& sampler, const PointArrays& points, const std::vector<bool>& samplable,
             const SampleArrays& samples, const std::vector<float>& densities, const std::string& where);

  Tally total() const;
  void print() const;

 private:
  static constexpr std::uint64_t most_told = 20;

  std::map<std::string, Tally> tallies_;
  mutable std::mutex mutex_;
};

}  // namespace hatbox::test
