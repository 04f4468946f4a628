#include "support/all_samplers.h"

#include "support/disk_maps.h"

namespace hatbox::test {
namespace {

Vec3 scaled(const Vec3& v, float scale) { return {scale * v.x, scale * v.y, scale * v.z}; }

Disk scaled(const Disk& light, float scale) {
  return {scaled(light.center, scale), light.normal, scale * light.radius};
}

}  // namespace

std::vector<Sampler> all_samplers(Pose pose, float scale) {
  std::vector<Sampler> result;
  const Disk disk = scaled(disk_in(pose), scale);
  for (const DiskMap map : all_disk_maps) result.emplace_back(std::string("disk_") + name(map), disk, map);
  return result;
}

}  // namespace hatbox::test
