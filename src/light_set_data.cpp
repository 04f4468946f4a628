// How a LightSet is made.
#include "light_set_data.h"

#include <limits>
#include <stdexcept>
#include <string>

namespace hatbox {
namespace {

template <class Light>
auto constants_of_all(const char* name, std::span<const Light> lights) {
  std::vector<decltype(ready(Light{}))> constants;
  constants.reserve(lights.size());
  for (std::size_t i = 0; i < lights.size(); ++i) {
    try {
      constants.push_back(ready(lights[i]));
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(std::string(name) + "[" + std::to_string(i) + "]: " + error.what());
    }
  }
  return constants;
}

template <class Map>
void check_map(const char* name, Map map, std::size_t count) {
  const auto index = static_cast<std::size_t>(map);
  if (index >= count) throw std::invalid_argument(std::string(name) + ": there is no map " + std::to_string(index));
}

void check_maps(const LightSet::Maps& maps) {
  check_map("maps.disk", maps.disk, decltype(KernelTable::disk)::map_count);
  check_map("maps.ellipse", maps.ellipse, decltype(KernelTable::ellipse)::map_count);
  check_map("maps.rectangle", maps.rectangle, decltype(KernelTable::rectangle)::map_count);
  check_map("maps.triangle", maps.triangle, decltype(KernelTable::triangle)::map_count);
}

std::array<std::uint32_t, light_kind_count + 1> bounds_of(const std::array<std::size_t, light_kind_count>& counts) {
  std::array<std::uint32_t, light_kind_count + 1> bounds = {};
  std::size_t total = 0;
  for (std::size_t kind = 0; kind < light_kind_count; ++kind) {
    total += counts[kind];
    if (total > std::numeric_limits<std::uint32_t>::max()) {
      throw std::invalid_argument("lights: " + std::to_string(total) + " are more than 32 bits can count");
    }
    bounds[kind + 1] = static_cast<std::uint32_t>(total);
  }
  return bounds;
}

}  // namespace

LightSet::LightSet(std::span<const Disk> disks, std::span<const Ellipse> ellipses,
                   std::span<const Rectangle> rectangles, std::span<const Triangle> triangles, const Maps& maps) {
  check_maps(maps);
  const auto bounds = bounds_of({disks.size(), ellipses.size(), rectangles.size(), triangles.size()});
  data_ = std::make_shared<const Data>(Data{constants_of_all("disks", disks), constants_of_all("ellipses", ellipses),
                                            constants_of_all("rectangles", rectangles),
                                            constants_of_all("triangles", triangles), maps, bounds});
}

std::size_t LightSet::size() const noexcept { return data_->size(); }

}  // namespace hatbox
