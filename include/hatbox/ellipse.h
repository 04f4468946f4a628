/// \file
/// Elliptical lights: sample, pdf, invert and solid angle for whole arrays of shading points.
///
/// All calls are thread-safe and allocate nothing (those of `parallel`: what TBB does). They throw
/// std::invalid_argument, before anything is written, if spans disagree in length, the light is not one (see `check`),
/// `map` is no EllipseMap or HATBOX_ISA no instruction set (isa.h); the message names the argument and its value. A
/// lane that cannot be sampled (its point in the light's plane, or nearer to it than 1e-32 of the longer semi-axis, or
/// not finite, its variate not finite, its solid angle not a normal float, or further away than 4·10^18 of the shorter
/// semi-axis) gets 0 in every output (`invert`: -1); no lane gets NaN, an infinity or a negative density, and none is
/// touched by another. A lane's bits depend on its own inputs alone: not on its place, on k, on the number of threads,
/// nor (but for sse4_2, see isa.h) on the instruction set. Scaling light and points by a power of two changes nothing
/// but `distance` and the last places of `pdf`.
///
/// Axes that are not quite perpendicular are made so: the shorter loses its part along the longer. Axes as long as each
/// other but for the rounding of their coordinates are a circle's, and all calls give what they give for a Disk.
#pragma once

#include <hatbox/arrays.h>
#include <hatbox/export.h>
#include <hatbox/lights.h>

#include <cstddef>
#include <span>
#include <string_view>

namespace hatbox {

/// How (u, v) becomes a direction to the ellipse. All are bijections of the square onto the ellipse as it is seen.
enum class EllipseMap {
  area,       ///< uniform in area: concentric map of the ellipse (Shirley and Chiu 1997). Cheapest, noisy close by
  ld_radial,  ///< uniform in solid angle, concentric: low distortion, keeps stratification (Guillén 2017, §3.3)
  radial,     ///< uniform in solid angle, polar: u turns about the centre, v goes from the centre to the rim (ibid.)
};

/// Samples k directions from each of n points: sample j of point i lies at [j·n + i] of `variates` and `out`. The k
/// samples of a point share its set-up, so that many cost less than their number.
///
/// `out.pdf` is the density of the map as it was computed, so estimates are unbiased whatever the rounding. For
/// ld_radial and radial it is 1/Ω within 1e-4 at 99.9 % of points with x, y within ±3 longer semi-axes and height 0.05
/// to 3.05, within 1e-4 from 10 of them on, and within 2e-2 at 99 % of points hugging the light (height 1e-5 to 1e-1).
/// Directions are right to 4e-6 rad beyond what the rounding of the inputs makes of them, and of unit length to 1e-6;
/// places are on the light to 1e-5, all of it for ellipses of 1 : 10^4 and rounder. Ellipses that are no circles do
/// better next to the light: their density is 1/Ω within 1e-4 at all of these points.
///
/// Cost: 12 to 14 times area sampling at one sample a point, two to four at 16; next to ellipses that are no circles up
/// to three times that. The README's tables have all.
///
/// Source: Guillén et al. 2017, eq. 3-5 and 16-23, in the form that src/ellipse_cone.h and src/eta_hybrid.h explain.
HATBOX_API void sample(const Ellipse& light, EllipseMap map, Points points, Variates variates, Samples out);

/// The density, per steradian, with which `sample` picks each of the k·n `directions` (unit length, not checked): 0 for
/// one that misses the light. The hit test has a margin of 8 ulp of the direction, in favour of a hit. `out` has k·n
/// elements. What `sample` returned is met to 1e-5, as far as a float direction can tell.
///
/// Cost at one a point, in samples by `area`: 12; `area` 7.
HATBOX_API void pdf(const Ellipse& light, EllipseMap map, Points points, Directions directions, std::span<float> out);

/// The density, per steradian, with which `sample` picks the direction to each of the k·n `places`: 0 outside the
/// light. What `sample` returned with the place is met to 1e-5 but within 1e-5 of the rim, where a float place does not
/// tell. For far lights the better of the two: a float direction cannot resolve what lies within 1e-7 rad.
///
/// Cost at one a point, in samples by `area`: 12; `area` ½.
HATBOX_API void pdf(const Ellipse& light, EllipseMap map, Points points, Places places, std::span<float> out);

/// The (u, v) that `sample` turns into each of the k·n `directions`: -1, -1 for one that misses the light or cannot be
/// sampled. Right to 1e-4 where the map is continuous and the light wide enough for a float direction to tell. `u` and
/// `v` have k·n elements each.
///
/// Cost at one a point, in samples by `area`: 13; `area` 7 to 8.
HATBOX_API void invert(const Ellipse& light, EllipseMap map, Points points, Directions directions, std::span<float> u,
                       std::span<float> v);

/// The solid angle of the light from each of the n points, in steradians, in (0, 2π), or 0: right to 2e-6, relative,
/// plus what the rounding of the inputs makes of themselves. `out` has n elements.
///
/// Cost at one a point, in samples by `area`: 7 to 8.
///
/// Source: Guillén et al. 2017, eq. 16-19, by Landen's transformation (src/solid_angle.h).
HATBOX_API void solid_angle(const Ellipse& light, Points points, std::span<float> out);

/// What is wrong with a light, beginning with the name of the member; empty if nothing is. Calls throw on a light that
/// does not pass, so hosts without exceptions ask here first.
HATBOX_API std::string_view check(const Ellipse& light) noexcept;

namespace parallel {

/// @{
/// The same calls, the points split into blocks by TBB, in the caller's task arena and isolated from its other tasks.
/// `grain` is the least number of points a block (0: chosen by the library); a job of one block runs in the caller's
/// thread. All threads flush denormals if that does.
HATBOX_API void sample(const Ellipse& light, EllipseMap map, Points points, Variates variates, Samples out,
                       std::size_t grain = 0);
HATBOX_API void pdf(const Ellipse& light, EllipseMap map, Points points, Directions directions, std::span<float> out,
                    std::size_t grain = 0);
HATBOX_API void pdf(const Ellipse& light, EllipseMap map, Points points, Places places, std::span<float> out,
                    std::size_t grain = 0);
HATBOX_API void invert(const Ellipse& light, EllipseMap map, Points points, Directions directions, std::span<float> u,
                       std::span<float> v, std::size_t grain = 0);
HATBOX_API void solid_angle(const Ellipse& light, Points points, std::span<float> out, std::size_t grain = 0);
/// @}

}  // namespace parallel

}  // namespace hatbox
