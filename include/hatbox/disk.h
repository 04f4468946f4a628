// Disk lights: sample, pdf, invert and solid angle for whole arrays of shading points.
#pragma once

#include <hatbox/arrays.h>
#include <hatbox/lights.h>

#include <cstddef>
#include <span>
#include <string_view>

namespace hatbox {

/// How (u, v) becomes a direction to the disk. All are bijections of the square onto the disk as it is seen.
enum class DiskMap {
  area,       ///< uniform in area: concentric map of the disk (Shirley and Chiu 1997). Cheapest, noisy close by
  ld_radial,  ///< uniform in solid angle, concentric: low distortion, keeps stratification (Guillén 2017, §3.3)
  radial,     ///< uniform in solid angle, polar: u turns about the centre, v goes from the centre to the rim (ibid.)
};

void sample(const Disk& light, DiskMap map, Points points, Variates variates, Samples out);

void pdf(const Disk& light, DiskMap map, Points points, Directions directions, std::span<float> out);

void pdf(const Disk& light, DiskMap map, Points points, Places places, std::span<float> out);

void invert(const Disk& light, DiskMap map, Points points, Directions directions, std::span<float> u,
            std::span<float> v);

void solid_angle(const Disk& light, Points points, std::span<float> out);

std::string_view check(const Disk& light) noexcept;

/// The axes of a place (s, t) on the light: perpendicular, in its plane, of the length of its radius.
struct Axes {
  Vec3 u, v;
};
Axes axes(const Disk& light);

namespace parallel {
void sample(const Disk& light, DiskMap map, Points points, Variates variates, Samples out, std::size_t grain = 0);
void pdf(const Disk& light, DiskMap map, Points points, Directions directions, std::span<float> out,
         std::size_t grain = 0);
void pdf(const Disk& light, DiskMap map, Points points, Places places, std::span<float> out, std::size_t grain = 0);
void invert(const Disk& light, DiskMap map, Points points, Directions directions, std::span<float> u,
            std::span<float> v, std::size_t grain = 0);
void solid_angle(const Disk& light, Points points, std::span<float> out, std::size_t grain = 0);
}  // namespace parallel

}  // namespace hatbox
