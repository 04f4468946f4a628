// Every light with every map, in the poses of the tests. The points of workloads.h lie around all of them.
#pragma once

#include "support/sampler.h"
#include "support/workloads.h"

#include <vector>

namespace hatbox::test {

/// Light and pose scaled about the world's origin.
std::vector<Sampler> all_samplers(Pose pose, float scale = 1);

}  // namespace hatbox::test
