// The bytes of the fuzzer as numbers, lengths and choices. Where they end a generator seeded by them goes on, so that a
// few bytes make whole calls: what is random is a function of the input.
#pragma once

#include "support/random.h"

#include <hatbox/lights.h>

#include <fuzzer/FuzzedDataProvider.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace hatbox::fuzz {

class Input {
 public:
  Input(const std::uint8_t* data, std::size_t size);

  std::uint32_t bits();
  std::size_t below(std::size_t count) { return bits() % count; }
  bool one_in(std::size_t count) { return below(count) == 0; }

  /// Any float: odd ones, small fractions, powers of two, any bits at all, and earlier ones again or some ulp aside, so
  /// that differences vanish or nearly do.
  float number();
  Vec3 vector() { return {number(), number(), number()}; }
  std::vector<float> numbers(std::size_t count);

  /// One that sampling might be given: in the square more often than not.
  float variate();

  /// How many points: around the widths of packets.
  std::size_t count();

 private:
  float fresh();

  FuzzedDataProvider data_;
  test::Random random_;
  std::vector<float> earlier_;
};

/// Numbers for a message, in every bit.
std::string told(const std::vector<float>& numbers);

/// Says what does not hold, and stops the program, which is what a fuzzer looks for.
void require(bool holds, const std::string& what);

}  // namespace hatbox::fuzz
