// What must hold of every lane, whatever it was called with.
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
  std::uint64_t tried = 0, valid = 0, failed = 0;
};

/// Collects verdicts from all threads; tells the first failures.
class Judge {
 public:
  /// `where` is for the message, with the lane behind it.
  void judge(const Sampler& sampler, const SampleArrays& samples, const std::vector<float>& densities,
             const std::string& where);

  Tally total() const;
  void print() const;

 private:
  static constexpr std::uint64_t most_told = 20;

  std::map<std::string, Tally> tallies_;
  mutable std::mutex mutex_;
};

}  // namespace hatbox::test
