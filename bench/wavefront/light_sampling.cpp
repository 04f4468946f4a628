#include "light_sampling.h"

#include "auto_switch.h"

#include <stdexcept>

namespace wavefront {
namespace {

using Sample = decltype(LightSampling::sample);

Sample by_map(hatbox::DiskMap map) {
  return [map](const auto& light, const auto& points, const auto& variates, const auto& out) {
    hatbox::parallel::sample(light, map, points, variates, out);
  };
}

/// Area sampling below so many steradians, as production renderers do it.
Sample far_switch(float below) {
  return [below](const auto& light, const auto& points, const auto& variates, const auto& out) {
    hatbox::bench::parallel::sample_auto(light, below, points, variates, out);
  };
}

Sample by_table(hatbox::DiskMap base) {
  return
      [table = hatbox::DiskTable(base)](const auto& light, const auto& points, const auto& variates, const auto& out) {
        hatbox::parallel::sample(light, table, points, variates, out);
      };
}

/// Made when asked for: a table takes its time.
struct Known {
  const char* name;
  Sample (*make)();
};

using hatbox::DiskMap;
constexpr Known known_samplings[] = {
    {"area", [] { return by_map(DiskMap::area); }},
    {"ld_radial", [] { return by_map(DiskMap::ld_radial); }},
    {"radial", [] { return by_map(DiskMap::radial); }},
    {"parallel", [] { return by_map(DiskMap::parallel); }},
    {"radial_carlson", [] { return by_map(DiskMap::radial_carlson); }},
    {"parallel_carlson", [] { return by_map(DiskMap::parallel_carlson); }},
    {"table", [] { return by_table(DiskMap::ld_radial); }},
    {"auto", [] { return far_switch(1e-2f); }},
};

}  // namespace

LightSampling light_sampling(std::string_view name) {
  for (const Known& known : known_samplings)
    if (name == known.name) return {known.name, known.make()};
  throw std::invalid_argument("unknown map '" + std::string(name) + "' (known: " + light_sampling_names() + ")");
}

std::string light_sampling_names() {
  std::string list;
  for (const Known& known : known_samplings) list += (list.empty() ? "" : ", ") + std::string(known.name);
  return list;
}

}  // namespace wavefront
