// What every stage of the renderer works with.
#pragma once

#include "light_table.h"
#include "queues.h"
#include "ray_tracer.h"
#include "settings.h"

namespace wavefront {

/// What samples are for: each has variates of its own.
enum class Dimension : std::uint64_t { light, scattering, distance, medium_light, medium_scattering };

struct Stage {
  const Scene& scene;
  const RayTracer& tracer;
  const LightTable& lights;
  const RenderSettings& settings;
  const Sampler& sampler;  // for 2^index_bits samples a pixel, no fewer than any stage takes
  int index_bits;
  std::size_t first_pixel = 0;  // of the chunk of the picture at work

  std::size_t pixel_of(std::size_t path) const { return first_pixel + path / settings.spp; }

  /// Of one pixel; `index` counts the samples of all its camera paths.
  Sample2 variate(Dimension dimension, std::size_t path, std::uint32_t index) const {
    const std::uint64_t seed = hash(settings.seed, static_cast<std::uint64_t>(dimension));
    const std::uint64_t key = hash(seed, pixel_of(path));
    // Shuffled, or the direction would be a function of the distance at which it begins, and the place in a step one of
    // the step's number.
    const bool in_medium = dimension >= Dimension::distance;
    return sampler(key, in_medium ? shuffle_index(index, index_bits, ~key) : index);
  }
};

}  // namespace wavefront
