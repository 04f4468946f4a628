// The ways to sample lights, by name: the library's maps, its table, and the far-light switch.
#pragma once

#include "names.h"
#include "scene.h"

#include <hatbox/light_set.h>

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace wavefront {

struct LightSampling {
  using SampleDisk =
      std::function<void(const hatbox::Disk&, const hatbox::Points&, const hatbox::Variates&, const hatbox::Samples&)>;

  std::string name;
  hatbox::LightSet::Maps maps;  // a kind of light that the name means nothing for has its best map
  SampleDisk sample_disk;       // for what no LightSet knows: samples a scene's only light, a disk, in parallel
  std::optional<Media> media;   // if the name says what to do in a medium
};

/// Throws std::invalid_argument, which lists the names there are.
LightSampling light_sampling(std::string_view name);

/// Throws std::invalid_argument, which lists the names that suit, unless `sampling` is for some of the scene's lights.
void check_suits(const LightSampling& sampling, const Scene& scene);

/// The names, separated by commas.
std::string light_sampling_names();

}  // namespace wavefront
