// The cases of sets of lights: points each of whom has its own, of 1 to a million lights of mixed kinds, beside calls
// for the same lights one by one.
#pragma once

#include "report.h"

#include <vector>

namespace hatbox::bench {

/// Registers every case with Google Benchmark, by the name `Case::name`, and returns them.
std::vector<Case> register_light_set_cases();

}  // namespace hatbox::bench
