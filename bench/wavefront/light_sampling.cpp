#include "light_sampling.h"

#include "auto_switch.h"

#include <hatbox/disk_table.h>

#include <algorithm>
#include <stdexcept>

namespace wavefront {
namespace {

using hatbox::DiskMap;
using hatbox::EllipseMap;
using hatbox::RectangleMap;
using hatbox::TriangleMap;
using SampleDisk = LightSampling::SampleDisk;

/// Area sampling below so many steradians, as production renderers do it.
SampleDisk far_switch() {
  constexpr float below = 1e-2f;
  return [](const auto& light, const auto& points, const auto& variates, const auto& out) {
    hatbox::bench::parallel::sample_auto(light, below, points, variates, out);
  };
}

SampleDisk table() {
  return [table = hatbox::DiskTable(DiskMap::ld_radial)](const auto& light, const auto& points, const auto& variates,
                                                         const auto& out) {
    hatbox::parallel::sample(light, table, points, variates, out);
  };
}

/// What a name means for each kind of light; nothing if it is not for that kind.
struct Known {
  const char* name;
  std::optional<DiskMap> disk;
  std::optional<EllipseMap> ellipse;
  std::optional<RectangleMap> rectangle;
  std::optional<TriangleMap> triangle;
  SampleDisk (*only_disk)() = nullptr;  // made when asked for: a table takes its time
  std::optional<Media> media = {};

  bool suits(const Light& light) const {
    const bool by_kind[] = {disk.has_value(), ellipse.has_value(), rectangle.has_value(), triangle.has_value()};
    static_assert(std::size(by_kind) == std::variant_size_v<Light>);
    return by_kind[light.index()];
  }

  bool suits(const Scene& scene) const {
    const auto& emitters = scene.emitters;
    if (only_disk) return emitters.size() == 1 && std::holds_alternative<hatbox::Disk>(emitters[0].light);
    return std::any_of(emitters.begin(), emitters.end(), [&](const Emitter& e) { return suits(e.light); });
  }
};

constexpr Known known_samplings[] = {
    {"best", DiskMap::ld_radial, EllipseMap::ld_radial, RectangleMap::spherical, TriangleMap::spherical},
    {"area", DiskMap::area, EllipseMap::area, RectangleMap::area, TriangleMap::area},
    {"area_first", DiskMap::area, EllipseMap::area, RectangleMap::area, TriangleMap::area, nullptr, Media::area_first},
    {"spherical", {}, {}, RectangleMap::spherical, TriangleMap::spherical},
    {"two_triangles", {}, {}, RectangleMap::two_triangles, {}},
    {"ld_radial", DiskMap::ld_radial, EllipseMap::ld_radial, {}, {}},
    {"radial", DiskMap::radial, EllipseMap::radial, {}, {}},
    {"parallel", DiskMap::parallel, {}, {}, {}},
    {"rejection", DiskMap::rejection, {}, {}, {}},
    {"radial_carlson", DiskMap::radial_carlson, {}, {}, {}},
    {"parallel_carlson", DiskMap::parallel_carlson, {}, {}, {}},
    {"table", {}, {}, {}, {}, table},
    {"auto", {}, {}, {}, {}, far_switch},
};

template <class Predicate>
std::string names_of(Predicate predicate) {
  std::string list;
  for (const Known& known : known_samplings)
    if (predicate(known)) list += (list.empty() ? "" : ", ") + std::string(known.name);
  return list;
}

const Known& find(std::string_view name) {
  for (const Known& known : known_samplings)
    if (name == known.name) return known;
  throw std::invalid_argument("unknown map '" + std::string(name) + "' (known: " + light_sampling_names() + ")");
}

}  // namespace

LightSampling light_sampling(std::string_view name) {
  const Known& known = find(name);
  LightSampling result{known.name, {}, {}, known.media};
  result.maps.disk = known.disk.value_or(result.maps.disk);
  result.maps.ellipse = known.ellipse.value_or(result.maps.ellipse);
  result.maps.rectangle = known.rectangle.value_or(result.maps.rectangle);
  result.maps.triangle = known.triangle.value_or(result.maps.triangle);
  if (known.only_disk) result.sample_disk = known.only_disk();
  return result;
}

void check_suits(const LightSampling& sampling, const Scene& scene) {
  if (!find(sampling.name).suits(scene))
    throw std::invalid_argument("map '" + sampling.name + "' is not for the lights of this scene (known: " +
                                names_of([&](const Known& known) { return known.suits(scene); }) + ")");
}

std::string light_sampling_names() {
  return names_of([](const Known&) { return true; });
}

}  // namespace wavefront
