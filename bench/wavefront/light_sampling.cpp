#include "light_sampling.h"

#include "auto_switch.h"

#include <stdexcept>
#include <utility>
#include <vector>

namespace wavefront {
namespace {

LightSampling by_map(const char* name, hatbox::DiskMap map) {
  return {name, [map](const auto& light, const auto& points, const auto& variates, const auto& out) {
            hatbox::parallel::sample(light, map, points, variates, out);
          }};
}

/// Area sampling below so many steradians, as production renderers do it.
LightSampling far_switch(const char* name, float below) {
  return {name, [below](const auto& light, const auto& points, const auto& variates, const auto& out) {
            hatbox::bench::parallel::sample_auto(light, below, points, variates, out);
          }};
}

LightSampling by_table(const char* name, hatbox::DiskMap base) {
  return {name, [table = hatbox::DiskTable(base)](const auto& light, const auto& points, const auto& variates,
                                                  const auto& out) {
            hatbox::parallel::sample(light, table, points, variates, out);
          }};
}

const std::vector<LightSampling>& all() {
  using hatbox::DiskMap;
  static const std::vector<LightSampling> result{
      by_map("area", DiskMap::area),         by_map("ld_radial", DiskMap::ld_radial), by_map("radial", DiskMap::radial),
      by_map("parallel", DiskMap::parallel), by_table("table", DiskMap::ld_radial),   far_switch("auto", 1e-2f)};
  return result;
}

}  // namespace

LightSampling light_sampling(std::string_view name) {
  for (const LightSampling& known : all())
    if (name == known.name) return known;
  throw std::invalid_argument("unknown map '" + std::string(name) + "' (known: " + light_sampling_names() + ")");
}

std::string light_sampling_names() {
  std::string list;
  for (const LightSampling& known : all()) list += (list.empty() ? "" : ", ") + known.name;
  return list;
}

}  // namespace wavefront
