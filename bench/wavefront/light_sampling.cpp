#include "light_sampling.h"

#include "auto_switch.h"

#include <optional>
#include <stdexcept>

namespace wavefront {
namespace {

using hatbox::DiskMap;
using hatbox::RectangleMap;
using hatbox::TriangleMap;
using DiskSample = LightSampling::Sample<hatbox::Disk>;

template <DiskMap map>
DiskSample disk() {
  return [](const auto& light, const auto& points, const auto& variates, const auto& out) {
    hatbox::parallel::sample(light, map, points, variates, out);
  };
}

/// Area sampling below so many steradians, as production renderers do it.
DiskSample far_switch() {
  constexpr float below = 1e-2f;
  return [](const auto& light, const auto& points, const auto& variates, const auto& out) {
    hatbox::bench::parallel::sample_auto(light, below, points, variates, out);
  };
}

DiskSample table() {
  return [table = hatbox::DiskTable(DiskMap::ld_radial)](const auto& light, const auto& points, const auto& variates,
                                                         const auto& out) {
    hatbox::parallel::sample(light, table, points, variates, out);
  };
}

/// What a name means for each kind of light; nothing if it is not for that kind.
struct Known {
  const char* name;
  DiskSample (*make_disk)();  // made when asked for: a table takes its time
  std::optional<RectangleMap> rectangle;
  std::optional<TriangleMap> triangle;

  bool suits(const Light& light) const {
    const bool by_kind[] = {make_disk != nullptr, rectangle.has_value(), triangle.has_value()};
    return by_kind[light.index()];
  }
};

constexpr const char* kinds[] = {"disks", "rectangles", "meshes"};  // by Light::index
static_assert(std::size(kinds) == std::variant_size_v<Light>);

constexpr Known known_samplings[] = {
    {"best", disk<DiskMap::ld_radial>, RectangleMap::spherical, TriangleMap::spherical},
    {"area", disk<DiskMap::area>, RectangleMap::area, TriangleMap::area},
    {"spherical", nullptr, RectangleMap::spherical, TriangleMap::spherical},
    {"two_triangles", nullptr, RectangleMap::two_triangles, {}},
    {"ld_radial", disk<DiskMap::ld_radial>, {}, {}},
    {"radial", disk<DiskMap::radial>, {}, {}},
    {"parallel", disk<DiskMap::parallel>, {}, {}},
    {"rejection", disk<DiskMap::rejection>, {}, {}},
    {"radial_carlson", disk<DiskMap::radial_carlson>, {}, {}},
    {"parallel_carlson", disk<DiskMap::parallel_carlson>, {}, {}},
    {"table", table, {}, {}},
    {"auto", far_switch, {}, {}},
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

void LightSampling::sample(const Light& light, const hatbox::Points& points, const hatbox::Variates& variates,
                           const hatbox::Samples& out) const {
  const auto sample_kind = [&]<class Kind>(const Kind& kind) {
    std::get<Sample<Kind>>(by_kind)(kind, points, variates, out);
  };
  std::visit(sample_kind, light);
}

LightSampling light_sampling(std::string_view name, Choice choice) {
  const Known& known = find(name);
  LightSampling result{known.name, {}};
  auto& [disk, rectangle, mesh] = result.by_kind;
  if (known.make_disk) disk = known.make_disk();
  if (known.rectangle)
    rectangle = [map = *known.rectangle](const auto& light, const auto& points, const auto& variates, const auto& out) {
      hatbox::parallel::sample(light, map, points, variates, out);
    };
  if (known.triangle)
    mesh = [map = *known.triangle, choice](const auto& light, const auto& points, const auto& variates,
                                           const auto& out) { sample_mesh(light, map, choice, points, variates, out); };
  return result;
}

void check_suits(const LightSampling& sampling, const Scene& scene) {
  for (const Emitter& emitter : scene.emitters)
    if (!find(sampling.name).suits(emitter.light))
      throw std::invalid_argument("map '" + sampling.name + "' is not for " + kinds[emitter.light.index()] +
                                  ", which this scene has for a light (known: " +
                                  names_of([&](const Known& known) { return known.suits(emitter.light); }) + ")");
}

std::string light_sampling_names() {
  return names_of([](const Known&) { return true; });
}

}  // namespace wavefront
