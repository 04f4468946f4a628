// What a LightSet holds: the constants of its lights, kind by kind, and which kernels each kind runs.
#pragma once

#include "kernel_table.h"

#include <hatbox/light_set.h>

#include <array>
#include <cstdint>
#include <vector>

namespace hatbox {

inline constexpr std::size_t light_kind_count = 4;  // disks, ellipses, rectangles, triangles

struct LightSet::Data {
  std::vector<DiskConstants> disks;
  std::vector<EllipseConstants> ellipses;
  std::vector<RectangleConstants> rectangles;
  std::vector<TriangleConstants> triangles;
  Maps maps;
  std::array<std::uint32_t, light_kind_count + 1> bounds;  // kind k has the indices [bounds[k], bounds[k + 1])

  std::size_t size() const { return bounds[light_kind_count]; }

  /// Calls visit(lights, kernels of the map, kernel of the solid angle) with those of a kind.
  template <class Visit>
  void visit(std::size_t kind, const KernelTable& table, const std::uint32_t* light, const Visit& visit) const {
    const auto at = [](auto map) { return static_cast<std::size_t>(map); };
    // the only one of its kind is given as to a call of its own: nothing need be gathered
    const auto rows = [&]<class Constants>(const std::vector<Constants>& lights) {
      return LightRows<Constants>{lights.data(), lights.size() == 1 ? nullptr : light, bounds[kind]};
    };
    if (kind == 0) return visit(rows(disks), table.disk.maps[at(maps.disk)], table.disk.solid_angle);
    if (kind == 1) return visit(rows(ellipses), table.ellipse.maps[at(maps.ellipse)], table.ellipse.solid_angle);
    if (kind == 2)
      return visit(rows(rectangles), table.rectangle.maps[at(maps.rectangle)], table.rectangle.solid_angle);
    return visit(rows(triangles), table.triangle.maps[at(maps.triangle)], table.triangle.solid_angle);
  }
};

}  // namespace hatbox
