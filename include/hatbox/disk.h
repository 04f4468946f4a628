/// \file
/// Disk lights: sample, pdf, invert and solid angle for whole arrays of shading points.
///
/// All calls are thread-safe and allocate nothing (those of `parallel`: what TBB does). They throw
/// std::invalid_argument, before anything is written, if spans disagree in length, the light is not one (see `check`),
/// `map` is no DiskMap, or `rejection` where an inverse is asked for, or HATBOX_ISA no instruction set (isa.h); the
/// message names the argument and its value. A lane that cannot be sampled (its point in the light's plane or not
/// finite, its variate not finite, its solid angle not a normal float) gets 0 in every output (`invert`: -1); no lane
/// gets NaN, an infinity or a negative density, and none is touched by another. A lane's bits depend on its own inputs
/// alone: not on its place, on k, on the number of threads, nor (but for sse4_2, see isa.h) on the instruction set.
/// Scaling light and points by a power of two changes nothing but `distance` and the last places of `pdf`.
#pragma once

#include <hatbox/arrays.h>
#include <hatbox/export.h>
#include <hatbox/lights.h>

#include <cstddef>
#include <span>
#include <string_view>

namespace hatbox {

/// How (u, v) becomes a direction to the disk. All but `rejection` are bijections of the square onto the disk as it is
/// seen.
enum class DiskMap {
  area,       ///< uniform in area: concentric map of the disk (Shirley and Chiu 1997). Cheapest, noisy close by
  ld_radial,  ///< uniform in solid angle, concentric: low distortion, keeps stratification (Guillén 2017, §3.3)
  radial,     ///< uniform in solid angle, polar: u turns about the centre, v goes from the centre to the rim (ibid.)
  parallel,   ///< uniform in solid angle, in slices: u goes across the minor axis, v along the slice (ibid., §3.2)
  rejection,  ///< uniform in solid angle over random (u, v): tries in the square about the disk (Gamito 2016)
  radial_carlson,    ///< as radial, by Carlson's elliptic integrals and Newton's method as in the paper: a baseline
  parallel_carlson,  ///< as parallel, in the same way; nothing from heights below about 1e-8 radii
};

/// Samples k directions from each of n points: sample j of point i lies at [j·n + i] of `variates` and `out`. The k
/// samples of a point share its set-up, so that many cost less than their number.
///
/// `out.pdf` is the density of the map as it was computed, so estimates are unbiased whatever the rounding. For
/// ld_radial, radial and parallel it is 1/Ω within 1e-4 at 99.9 % of points with x, y within ±3 radii and height 0.05
/// to 3.05, within 1e-6 from 10 radii on, and within 2e-2 at 99 % of points hugging the light (height 1e-5 to 1e-1);
/// for radial_carlson and parallel_carlson within 2e-6 at all of these, plus what the rounding of the inputs makes of
/// Ω. Directions are of unit length to 1e-6, and right to 4e-6 rad, from points hugging the light at 99 % of them;
/// there those of ld_radial, radial and parallel to 1e-4. Places are on the disk to 1e-6.
///
/// `rejection` takes (u, v) for a point of the square about the disk, and where that misses the disk, as one in four to
/// five does, pseudorandom points that are a function of (u, v) alone. Stratification is lost there. Up to 15 tries;
/// all of them fail with a probability below 1e-9, and the lane is then as one that cannot be sampled. Its density is
/// 1/Ω to 2e-6, plus what the rounding of the inputs makes of Ω.
///
/// Cost: ld_radial and radial four to seven times area sampling at one sample a point, about twice at 16; parallel,
/// radial_carlson and parallel_carlson 12 to 17 times at one, 6 to 10 at 16; rejection 12 to 24 times. The README's
/// tables have all.
///
/// Source: Guillén et al. 2017, eq. 3-5 and 16-23, in the form that src/disk_cone.h and src/eta_series.h explain.
HATBOX_API void sample(const Disk& light, DiskMap map, Points points, Variates variates, Samples out);

/// The density, per steradian, with which `sample` picks each of the k·n `directions` (unit length, not checked): 0 for
/// one that misses the light. The hit test has a margin of 8 ulp of the direction, in favour of a hit. `out` has k·n
/// elements. What `sample` returned is met to 1e-5, as far as a float direction can tell.
///
/// Cost at one a point, in samples by `area`: 5 to 8; `area` 3.
HATBOX_API void pdf(const Disk& light, DiskMap map, Points points, Directions directions, std::span<float> out);

/// The density, per steradian, with which `sample` picks the direction to each of the k·n `places`: 0 outside the
/// light. What `sample` returned with the place is met to 1e-5 but within 1e-5 of the rim, where a float place does not
/// tell. For far lights the better of the two: a float direction cannot resolve what lies within 1e-7 rad. (To be
/// called with a `Places{s, t}`: mere braces may be directions too.)
///
/// Cost at one a point, in samples by `area`: 5 to 8; `area` ½.
HATBOX_API void pdf(const Disk& light, DiskMap map, Points points, Places places, std::span<float> out);

/// The (u, v) that `sample` turns into each of the k·n `directions`: -1, -1 for one that misses the light or cannot be
/// sampled. Right to 1e-4 where the map is continuous and the light wide enough for a float direction to tell. `u` and
/// `v` have k·n elements each. Not for `rejection`, which has no inverse.
///
/// Cost at one a point, in samples by `area`: 8 to 9; `area` 3.
HATBOX_API void invert(const Disk& light, DiskMap map, Points points, Directions directions, std::span<float> u,
                       std::span<float> v);

/// The solid angle of the light from each of the n points, in steradians, in (0, 2π), or 0: right to 2e-6, relative,
/// plus what the rounding of the inputs makes of themselves. `out` has n elements.
///
/// Cost at one a point, in samples by `area`: 3 to 4.
///
/// Source: Guillén et al. 2017, eq. 16-19, by Landen's transformation (src/solid_angle.h).
HATBOX_API void solid_angle(const Disk& light, Points points, std::span<float> out);

/// What is wrong with a light, beginning with the name of the member; empty if nothing is. Calls throw on a light that
/// does not pass, so hosts without exceptions ask here first.
HATBOX_API std::string_view check(const Disk& light) noexcept;

/// The axes of a place (s, t) on the light: perpendicular to each other and to the normal (u × v points along it), of
/// the length of its radius. Where normal is +z they are x and y.
struct Axes {
  /// @{
  Vec3 u, v;  ///< world units
  /// @}
};

/// The axes of places on this light. Throws std::invalid_argument if it is not one.
HATBOX_API Axes axes(const Disk& light);

namespace parallel {

/// @{
/// The same calls, the points split into blocks by TBB, in the caller's task arena and isolated from its other tasks.
/// `grain` is the least number of points a block (0: chosen by the library); a job of one block runs in the caller's
/// thread. All threads flush denormals if that does.
HATBOX_API void sample(const Disk& light, DiskMap map, Points points, Variates variates, Samples out,
                       std::size_t grain = 0);
HATBOX_API void pdf(const Disk& light, DiskMap map, Points points, Directions directions, std::span<float> out,
                    std::size_t grain = 0);
HATBOX_API void pdf(const Disk& light, DiskMap map, Points points, Places places, std::span<float> out,
                    std::size_t grain = 0);
HATBOX_API void invert(const Disk& light, DiskMap map, Points points, Directions directions, std::span<float> u,
                       std::span<float> v, std::size_t grain = 0);
HATBOX_API void solid_angle(const Disk& light, Points points, std::span<float> out, std::size_t grain = 0);
/// @}

}  // namespace parallel

}  // namespace hatbox
