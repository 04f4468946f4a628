// A light and a map of it, of whatever kinds, with the library's calls bound to them: what is promised of all samplers
// is tested on all of them alike.
#pragma once

#include "support/outline.h"

#include <hatbox/hatbox.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>

namespace hatbox::test {

/// How a call is run: sequentially, or in parallel with a grain.
using Grain = std::optional<std::size_t>;

template <class Map>
bool has_inverse(const Map&) {
  return true;
}
inline bool has_inverse(DiskMap map) { return map != DiskMap::rejection; }

struct Sampler {
  Sampler() = default;

  template <class Light, class Map>
  Sampler(std::string sampler_name, const Light& light, const Map& map);

  std::string name;
  Outline outline;  // nowhere, of a set
  std::function<void(const Points&, const Variates&, const Samples&, Grain)> sample;
  std::function<void(const Points&, const Directions&, std::span<float>, Grain)> pdf_of_direction;
  std::function<void(const Points&, const Places&, std::span<float>, Grain)> pdf_of_place;
  std::function<void(const Points&, const Directions&, std::span<float> u, std::span<float> v, Grain)>
      invert;  // or none
  std::function<void(const Points&, std::span<float>, Grain)> solid_angle;
};

template <class Light, class Map>
Sampler::Sampler(std::string sampler_name, const Light& light, const Map& map)
    : name(std::move(sampler_name)),
      outline(check(light).empty() ? outline_of(light) : Outline{}),
      sample([=](const Points& points, const Variates& variates, const Samples& out, Grain grain) {
        grain ? parallel::sample(light, map, points, variates, out, *grain)
              : hatbox::sample(light, map, points, variates, out);
      }),
      pdf_of_direction([=](const Points& points, const Directions& directions, std::span<float> out, Grain grain) {
        grain ? parallel::pdf(light, map, points, directions, out, *grain)
              : hatbox::pdf(light, map, points, directions, out);
      }),
      pdf_of_place([=](const Points& points, const Places& places, std::span<float> out, Grain grain) {
        grain ? parallel::pdf(light, map, points, places, out, *grain) : hatbox::pdf(light, map, points, places, out);
      }),
      solid_angle([=](const Points& points, std::span<float> out, Grain grain) {
        grain ? parallel::solid_angle(light, points, out, *grain) : hatbox::solid_angle(light, points, out);
      }) {
  if (!has_inverse(map)) return;
  invert = [=](const Points& points, const Directions& directions, std::span<float> u, std::span<float> v,
               Grain grain) {
    grain ? parallel::invert(light, map, points, directions, u, v, *grain)
          : hatbox::invert(light, map, points, directions, u, v);
  };
}

}  // namespace hatbox::test
