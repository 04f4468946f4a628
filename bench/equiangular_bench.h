// The cases of equiangular sampling: their light is a "segment".
#pragma once

#include "report.h"

#include <vector>

namespace hatbox::bench {

/// Registers every case with Google Benchmark, by the name `Case::name`, and returns them.
std::vector<Case> register_equiangular_cases();

}  // namespace hatbox::bench
