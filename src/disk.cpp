// The public calls for disks.
#include "calls.h"
#include "dispatch.h"

#include <hatbox/disk.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace hatbox {
namespace {

const MapKernels<DiskConstants>& kernels_of(DiskMap map) {
  return hatbox::kernels_of(active_kernels().disk, map, "DiskMap");
}

const MapKernels<DiskConstants>& invertible_kernels_of(DiskMap map) {
  const MapKernels<DiskConstants>& kernels = kernels_of(map);
  if (kernels.invert == nullptr) throw std::invalid_argument("map: DiskMap::rejection has no inverse");
  return kernels;
}

Vec3 scaled(const float (&v)[3], float factor) { return {v[0] * factor, v[1] * factor, v[2] * factor}; }

}  // namespace

std::string_view check(const Disk& light) noexcept {
  if (!is_finite(light.center)) return "light.center is not finite";
  if (!is_finite(light.normal)) return "light.normal is not finite";
  if (light.normal.x == 0 && light.normal.y == 0 && light.normal.z == 0) return "light.normal is zero";
  if (!std::isfinite(light.radius)) return "light.radius is not finite";
  if (light.radius <= 0) return "light.radius is not positive";
  return {};
}

DiskConstants ready(const Disk& light) {
  const std::string_view problem = check(light);
  if (problem.empty()) return constants_of<float>(light);
  throw std::invalid_argument(std::string(problem) + "; center " + to_string(light.center) + ", normal " +
                              to_string(light.normal) + ", radius " + to_string(light.radius));
}

Axes axes(const Disk& light) {
  const DiskConstants constants = ready(light);
  return {scaled(constants.axes[0], light.radius), scaled(constants.axes[1], light.radius)};
}

void sample(const Disk& light, DiskMap map, Points points, Variates variates, Samples out) {
  call_sample({}, kernels_of(map), ready(light), points, variates, out);
}

void pdf(const Disk& light, DiskMap map, Points points, Directions directions, std::span<float> out) {
  call_pdf({}, kernels_of(map), ready(light), points, directions, out);
}

void pdf(const Disk& light, DiskMap map, Points points, Places places, std::span<float> out) {
  call_pdf({}, kernels_of(map), ready(light), points, places, out);
}

void invert(const Disk& light, DiskMap map, Points points, Directions directions, std::span<float> u,
            std::span<float> v) {
  call_invert({}, invertible_kernels_of(map), ready(light), points, directions, u, v);
}

void solid_angle(const Disk& light, Points points, std::span<float> out) {
  call_solid_angle({}, active_kernels().disk.solid_angle, ready(light), points, out);
}

namespace parallel {

void sample(const Disk& light, DiskMap map, Points points, Variates variates, Samples out, std::size_t grain) {
  call_sample(parallel_with(grain), kernels_of(map), ready(light), points, variates, out);
}

void pdf(const Disk& light, DiskMap map, Points points, Directions directions, std::span<float> out,
         std::size_t grain) {
  call_pdf(parallel_with(grain), kernels_of(map), ready(light), points, directions, out);
}

void pdf(const Disk& light, DiskMap map, Points points, Places places, std::span<float> out, std::size_t grain) {
  call_pdf(parallel_with(grain), kernels_of(map), ready(light), points, places, out);
}

void invert(const Disk& light, DiskMap map, Points points, Directions directions, std::span<float> u,
            std::span<float> v, std::size_t grain) {
  call_invert(parallel_with(grain), invertible_kernels_of(map), ready(light), points, directions, u, v);
}

void solid_angle(const Disk& light, Points points, std::span<float> out, std::size_t grain) {
  call_solid_angle(parallel_with(grain), active_kernels().disk.solid_angle, ready(light), points, out);
}

}  // namespace parallel
}  // namespace hatbox
