// The cases of the ellipse: half as wide as long, in place of the disk.
#pragma once

#include "report.h"

#include <vector>

namespace hatbox::bench {

/// Registers every case with Google Benchmark, by the name `Case::name`, and returns them.
std::vector<Case> register_ellipse_cases();

}  // namespace hatbox::bench
