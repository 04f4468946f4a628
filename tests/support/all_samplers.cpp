#include "support/all_samplers.h"

#include "support/disks.h"
#include "support/ellipses.h"
#include "support/rectangles.h"
#include "support/triangle_lights.h"

namespace hatbox::test {
namespace {

Vec3 scaled(const Vec3& v, float scale) { return {scale * v.x, scale * v.y, scale * v.z}; }

Disk scaled(const Disk& light, float scale) {
  return {scaled(light.center, scale), light.normal, scale * light.radius};
}

/// Made once: they are the same for every light.
const std::vector<DiskTable>& tables() {
  static const std::vector<DiskTable> result{DiskTable(DiskMap::ld_radial, 8), DiskTable(DiskMap::ld_radial, 64),
                                             DiskTable(DiskMap::radial, 8), DiskTable(DiskMap::radial, 64)};
  return result;
}

Rectangle scaled(const Rectangle& light, float scale) {
  return {scaled(light.corner, scale), scaled(light.edge_u, scale), scaled(light.edge_v, scale)};
}

Triangle scaled(const Triangle& light, float scale) {
  return {scaled(light.a, scale), scaled(light.b, scale), scaled(light.c, scale)};
}

}  // namespace

std::vector<Sampler> all_samplers(Pose pose, float scale) {
  std::vector<Sampler> result;
  const Disk disk = scaled(disk_in(pose), scale);
  for (const DiskMap map : all_disk_maps) result.emplace_back(std::string("disk_") + name(map), disk, map);
  for (const DiskTable& table : tables()) {
    const std::string map = std::string("disk_table_") + name(table.base());
    result.emplace_back(map + "_" + std::to_string(table.resolution()), disk, table);
  }
  for (const double aspect : {0.5, 10.0, 0.01}) {
    const Ellipse ellipse = test::scaled(ellipse_in(pose, aspect), scale);
    for (const EllipseMap map : all_ellipse_maps) {
      result.emplace_back("ellipse_" + std::to_string(aspect) + "_" + name(map), ellipse, map);
    }
  }
  for (const Shape shape : {Shape::square, Shape::tall}) {
    const Rectangle rectangle = scaled(rectangle_in(pose, shape), scale);
    for (const RectangleMap map : all_rectangle_maps) {
      result.emplace_back(std::string(name(shape)) + "_" + name(map), rectangle, map);
    }
  }
  const Triangle triangle = scaled(cornered_triangle_in(pose), scale);
  for (const TriangleMap map : all_triangle_maps) {
    result.emplace_back(std::string("triangle_") + name(map), triangle, map);
  }
  return result;
}

}  // namespace hatbox::test
