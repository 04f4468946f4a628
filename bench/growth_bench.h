// The cases that plots of cost are made of: a disk and a rectangle on every instruction set, over the samples a point
// and over the threads. Those of sets of lights are in light_set_bench.h.
#pragma once

#include "report.h"

#include <vector>

namespace hatbox::bench {

/// Registers every case with Google Benchmark, by the name `Case::name`, and returns them.
std::vector<Case> register_growth_cases();

}  // namespace hatbox::bench
