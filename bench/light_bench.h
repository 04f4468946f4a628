// The cases of the lights that have nothing to themselves: their maps on every instruction set, one sample a point and
// many, all that in cache.
#pragma once

#include "report.h"

#include <vector>

namespace hatbox::bench {

/// Registers every case with Google Benchmark, by the name `Case::name`, and returns them.
std::vector<Case> register_light_cases();

}  // namespace hatbox::bench
