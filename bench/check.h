// Whether what users were promised of speed still holds: a list of ratios with their bounds (baseline.json), measured
// and judged.
#pragma once

#include "report.h"

#include <string>
#include <vector>

namespace hatbox::bench {

/// Measures the cases that the file names, and no others, prints a table, and tells whether every ratio is within its
/// bound. A ratio that is not is measured again, alone, up to twice, and the best one counts: what else the machine
/// does makes ratios worse, seldom better. Checks that this machine has no instruction set or no threads for are
/// skipped, and the table says so. Throws std::runtime_error, which names the place, if the file is not as it should
/// be.
bool check_baseline(const std::string& path, const std::vector<Case>& cases, int repetitions);

}  // namespace hatbox::bench
