// Lights and shading points that nobody would think of: any size and place and turn, and points on the plane, on the
// rim, at the centre, a hair above, from 1e-30 to 1e18 sizes away, not finite; with variates on the edge and beyond.
// And which of these ought to be sampled all the same (samplable.h).
#pragma once

#include "support/random.h"
#include "support/sampler.h"
#include "support/workloads.h"

#include <cstdint>
#include <vector>

namespace hatbox::test {

/// One light of each kind with every map, a set of all four, and what to call them with. Made from a number.
struct HostileScene {
  HostileScene(std::uint64_t number, std::size_t size);

  std::vector<Sampler> samplers;
  std::vector<std::vector<bool>> samplable;  // for each sampler, whether a lane ought to be sampled
  PointArrays points;
  VariateArrays variates;
};

}  // namespace hatbox::test
