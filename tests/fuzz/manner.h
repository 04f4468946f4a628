// How a call is made and what is looked at whoever is called: the instruction set, denormals, threads; the exception.
#pragma once

#include "fuzz/input.h"
#include "support/denormals.h"
#include "support/isa_fixture.h"
#include "support/sampler.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace hatbox::fuzz {

struct Manner {
  explicit Manner(Input& input)
      : isa(available_isas()[input.below(available_isas().size())]),
        flushing(input.one_in(4)),
        grain(input.one_in(3) ? test::Grain(input.below(20)) : test::Grain()) {}

  /// Makes a call that must be refused or not: std::invalid_argument and no other exception, before anything is written
  /// to `outputs`, which are full of SampleArrays::untouched.
  template <class Call>
  void run(bool refused, const std::vector<const std::vector<float>*>& outputs, const std::string& what,
           const Call& call) const;

  std::string told() const {
    return std::string(" (") + name(isa) + (flushing ? ", denormals flushed" : "") + (grain ? ", in parallel)" : ")");
  }

  Isa isa;
  bool flushing;  // in all that is done with the input
  test::Grain grain;
};

template <class Call>
void Manner::run(bool refused, const std::vector<const std::vector<float>*>& outputs, const std::string& what,
                 const Call& call) const {
  const test::ForcedIsa forced(isa);
  try {
    call();
  } catch (const std::invalid_argument& error) {
    require(refused, what + " was refused: " + error.what());
    require(std::string(error.what()).size() > 3, what + ": the exception names nothing");
    for (const auto* output : outputs) {
      for (const float value : *output) {
        require(value == test::SampleArrays::untouched, what + " wrote before it was refused");
      }
    }
    return;
  }
  require(!refused, what + " should have been refused");
}

}  // namespace hatbox::fuzz
