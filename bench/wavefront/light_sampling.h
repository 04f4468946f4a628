// The ways to sample a light, by name: the library's maps, its table, and the far-light switch.
#pragma once

#include "mesh_light.h"

#include <functional>
#include <string>
#include <string_view>
#include <tuple>

namespace wavefront {

struct LightSampling {
  template <class Kind>
  using Sample =
      std::function<void(const Kind&, const hatbox::Points&, const hatbox::Variates&, const hatbox::Samples&)>;

  std::string name;
  std::tuple<Sample<hatbox::Disk>, Sample<hatbox::Rectangle>, Sample<MeshLight>> by_kind;  // empty: not for that kind

  /// Fills a batch of samples of one light that it suits; runs in parallel.
  void sample(const Light& light, const hatbox::Points& points, const hatbox::Variates& variates,
              const hatbox::Samples& out) const;
};

/// Throws std::invalid_argument, which lists the names there are. `choice` is for meshes.
LightSampling light_sampling(std::string_view name, Choice choice = Choice::solid_angle);

/// Throws std::invalid_argument, which lists the names that suit, unless `sampling` suits every light of the scene.
void check_suits(const LightSampling& sampling, const Scene& scene);

/// The names, separated by commas.
std::string light_sampling_names();

}  // namespace wavefront
