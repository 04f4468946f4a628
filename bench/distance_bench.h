// Whether a renderer should switch to area sampling for far lights: cost and error of area sampling, of ld_radial and
// of such a switch (auto_switch.h) over the distance to the light.
#pragma once

#include "report.h"

#include <vector>

namespace hatbox::bench {

/// Registers the cases with Google Benchmark.
std::vector<DistanceRow> register_distance_cases();

/// Fills in costs and errors and prints the table. Cases that did not run are left out.
std::vector<DistanceRow> measure_distances(std::vector<DistanceRow> rows, const Collector& collector);

}  // namespace hatbox::bench
