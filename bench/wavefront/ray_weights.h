// How much of a light's radiance a ray through the medium can expect: what lights are chosen by, for rays.
#pragma once

#include "light_table.h"
#include "queues.h"

#include <tbb/enumerable_thread_specific.h>

namespace wavefront {

/// Luminance × area × ∫ dt/r² over the part of the ray that the light shines on, r from the light's centre: its solid
/// angle, as if it were far and turned to each place, summed along the ray. The integral is the inverse of r² times the
/// equiangular density, anywhere on the ray. Solid angles stay below 2π, and so does their mean.
class RayWeights {
 public:
  RayWeights(const LightTable& lights, const RayColumns& rays) : lights_(lights), rays_(rays) {}

  /// See LightChoice::Weigh.
  void operator()(std::uint32_t light, std::size_t begin, std::span<float> out);

 private:
  struct Scratch {
    VectorColumns pivots, normals;
    std::vector<float> begin, end, u, distance, pdf;
    void fill(std::size_t n, const LightFacts& light);
  };

  const LightTable& lights_;
  const RayColumns& rays_;
  tbb::enumerable_thread_specific<Scratch> scratch_;
};

}  // namespace wavefront
