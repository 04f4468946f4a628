// How evenly a map covers its light.
#pragma once

#include "support/sampler.h"
#include "support/workloads.h"

#include <cstddef>
#include <vector>

namespace hatbox::test {

/// For each point, how far pdf·Ω strays: from one, and between any two of side² samples.
std::vector<double> variations(const Sampler& sampler, const PointArrays& points, std::size_t side);

}  // namespace hatbox::test
