// What every stage of the renderer works with.
#pragma once

#include "light_table.h"
#include "queues.h"
#include "ray_tracer.h"
#include "settings.h"

namespace wavefront {

/// What samples are for: each has variates of its own, those past `count` the vertices after bounces.
enum class Dimension : std::uint64_t { light, scattering, distance, medium_light, medium_scattering, count };

constexpr Dimension after_bounce(Dimension dimension, std::uint32_t bounce) {
  return static_cast<Dimension>(static_cast<std::uint64_t>(dimension) +
                                bounce * static_cast<std::uint64_t>(Dimension::count));
}

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
    // The same goes for a direction after a bounce and the direction of the bounce.
    const bool follows = dimension >= Dimension::distance;
    return sampler(key, follows ? shuffle_index(index, index_bits, ~key) : index);
  }

  /// For the direction of a bounce. Where paths go is a matter of their places, not of the seed: see RenderSettings.
  Sample2 bounce_variate(std::uint32_t bounce, std::size_t path) const {
    constexpr std::uint64_t bounce_seed = 0x626f756e6365;
    const std::uint64_t key = hash(hash(bounce_seed, bounce), pixel_of(path));
    const auto index = static_cast<std::uint32_t>(path % settings.spp);
    return sampler(key, shuffle_index(index, index_bits, ~key));
  }
};

/// Puts a point that a camera path arrived at into the queue of a block; `through` is what is left of its light there.
inline void add_surface(const SurfacePoint& point, const Rgb& through, std::size_t path, std::uint32_t sequence,
                        std::size_t block, VertexQueue& surfaces) {
  const std::size_t i = surfaces.add(block);
  surfaces.position.set(i, point.position);
  surfaces.axis.set(i, point.normal);
  surfaces.ray_origin.set(i, point.shadow_origin);
  surfaces.throughput[i] = point.shape->reflectance * through;
  surfaces.path[i] = static_cast<std::uint32_t>(path);
  surfaces.sequence[i] = sequence;
  surfaces.light[i] = any_light;
}

}  // namespace wavefront
