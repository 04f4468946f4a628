// What a picture is to be rendered with.
#pragma once

#include "light_sampling.h"
#include "names.h"
#include "sampler.h"

#include <cstdint>

namespace wavefront {

/// Every pixel has `spp` places through which camera rays go, and every camera ray that hits something takes
/// `light_samples` samples of direct light, each of one light. In a medium it gathers light at as many places as it
/// takes samples (with Media::march at `steps` times as many).
///
/// The places, and where paths go from there, depend on spp, the size and the kind of sampler, not on the seed. So the
/// images of one scene differ by their light samples alone, and the difference to a reference with the same places (and
/// more light samples at each) is the error of light sampling and nothing else: places drawn anew for every image would
/// add the noise of the silhouettes, the same for every map.
struct RenderSettings {
  int width;
  int height;
  std::uint32_t spp;
  std::uint32_t light_samples = 1;
  LightSampling sampling = light_sampling("best");
  Choice choice = Choice::solid_angle;
  Strategy strategy = Strategy::light;
  Media media = Media::equiangular;
  std::uint32_t steps = 4;
  std::uint32_t depth = 1;  // surfaces of a path that gather light: 1 is direct light alone
  SamplerKind sampler = SamplerKind::zero_two;
  std::uint64_t seed = 0;  // of the light samples

  /// Places in the medium at which a camera path gathers light.
  std::uint32_t medium_samples() const { return light_samples * (media_used() == Media::march ? steps : 1); }

  Media media_used() const { return sampling.media.value_or(media); }
  bool samples_lights() const { return strategy != Strategy::bsdf; }
  bool samples_scattering() const { return strategy != Strategy::light; }
};

}  // namespace wavefront
