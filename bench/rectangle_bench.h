// The cases of the rectangle.
#pragma once

#include "report.h"

#include <vector>

namespace hatbox::bench {

/// Registers every case with Google Benchmark, by the name `Case::name`, and returns them.
std::vector<Case> register_rectangle_cases();

}  // namespace hatbox::bench
