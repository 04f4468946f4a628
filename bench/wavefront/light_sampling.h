// The ways to sample a light, by name: the library's maps, its table, and the far-light switch.
#pragma once

#include <hatbox/hatbox.h>

#include <functional>
#include <string>
#include <string_view>

namespace wavefront {

struct LightSampling {
  std::string name;
  /// Fills a batch of samples of one light; runs in parallel.
  std::function<void(const hatbox::Disk&, const hatbox::Points&, const hatbox::Variates&, const hatbox::Samples&)>
      sample;
};

/// Throws std::invalid_argument, which lists the names there are.
LightSampling light_sampling(std::string_view name);

/// The names, separated by commas.
std::string light_sampling_names();

}  // namespace wavefront
