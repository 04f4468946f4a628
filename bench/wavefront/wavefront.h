// The renderer: direct light on Lambertian surfaces, computed for many paths at a time, one stage after the other.
#pragma once

#include "film.h"
#include "light_sampling.h"
#include "ray_tracer.h"
#include "sampler.h"
#include "scene.h"

#include <cstdint>
#include <string>

namespace wavefront {

/// Every pixel has `spp` places through which camera rays go, and every camera ray that hits something takes
/// `light_samples` samples of each light.
///
/// The places depend on spp, the size and the kind of sampler, not on the seed. So the images of one scene differ by
/// their light samples alone, and the difference to a reference with the same places (and more light samples at each)
/// is the error of light sampling and nothing else: places drawn anew for every image would add the noise of the
/// silhouettes, the same for every map.
struct RenderSettings {
  int width;
  int height;
  std::uint32_t spp;
  std::uint32_t light_samples = 1;
  LightSampling sampling = light_sampling("best");
  SamplerKind sampler = SamplerKind::zero_two;
  std::uint64_t seed = 0;  // of the light samples
};

struct Render {
  Image image;
  std::uint64_t light_samples = 0;  // how many were taken in all
  double light_seconds = 0;         // time in LightSampling::sample alone
  double seconds = 0;
};

Render render(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings, const std::string& label);

}  // namespace wavefront
