// The cases of the elliptic integrals.
#pragma once

#include "report.h"

#include <vector>

namespace hatbox::bench {

/// Registers every case with Google Benchmark, by the name `Case::name`, and returns them.
std::vector<Case> register_carlson_cases();

}  // namespace hatbox::bench
