// The renderer: light on Lambertian surfaces, direct or after bounces, and single scattering in fog, computed for many
// camera paths at a time, one stage after the other. A stage is a function from queues to queues, arrays of structures
// column by column:
//
//   camera rays (camera_stage.h)       → vertices on surfaces, parts of rays in the medium
//   medium sampling (medium_stage.h)   → vertices in the medium
//   for both queues of vertices alike:
//     light choice (light_choice.h)    → a light and its probability for each sample
//     light sampling (the library)     → directions, distances, densities
//     shadow rays (light_stage.h)      → radiance
//     scattering rays (scatter_stage.h) for the strategies bsdf and mis → more of it
//   bounces (bounce_stage.h)         → vertices on surfaces, for the same once more, as often as `depth` says
//   film                               → the sum of each pixel
#pragma once

#include "film.h"
#include "ray_tracer.h"
#include "scene.h"
#include "settings.h"

#include <cstdint>
#include <string>

namespace wavefront {

struct Render {
  Image image;
  std::uint64_t light_samples = 0;  // how many were taken in all
  double light_seconds = 0;         // time for choosing and sampling lights alone
  double seconds = 0;
};

/// Throws std::invalid_argument if the settings do not suit the scene.
void check(const Scene& scene, const RenderSettings& settings);

/// Checks and renders; `label` is for the progress bar.
Render render(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings, const std::string& label);

}  // namespace wavefront
