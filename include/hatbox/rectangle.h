/// \file
/// Rectangular lights: sample, pdf, invert and solid angle for whole arrays of shading points.
///
/// All calls are thread-safe and allocate nothing (those of `parallel`: what TBB does). They throw
/// std::invalid_argument, before anything is written, if spans disagree in length, the light is not one (see `check`),
/// `map` is no RectangleMap or HATBOX_ISA no instruction set (isa.h); the message names the argument and its value. A
/// lane that cannot be sampled (its point in the light's plane or not finite, its variate not finite, its solid angle
/// not a normal float) gets 0 in every output (`invert`: -1); no lane gets NaN, an infinity or a negative density, and
/// none is touched by another. A lane's bits depend on its own inputs alone: not on its place, on k, on the number of
/// threads, nor (but for sse4_2, see isa.h) on the instruction set. Scaling light and points by a power of two changes
/// nothing but `distance` and the last places of `pdf`.
#pragma once

#include <hatbox/arrays.h>
#include <hatbox/export.h>
#include <hatbox/lights.h>

#include <cstddef>
#include <span>
#include <string_view>

namespace hatbox {

/// How (u, v) becomes a direction to the rectangle. All are bijections of the square onto the rectangle as it is seen.
enum class RectangleMap {
  area,           ///< uniform in area: u along edge_u, v along edge_v. Cheapest, noisy close by
  spherical,      ///< uniform in solid angle (Ureña 2013): u moves a line over the light, v a point along it
  two_triangles,  ///< uniform in solid angle, by the triangles on either side of the diagonal from `corner` (Arvo 1995)
};

/// Samples k directions from each of n points: sample j of point i lies at [j·n + i] of `variates` and `out`. The k
/// samples of a point share its set-up, so that many cost less than their number. A place (s, t) is
/// corner + s·edge_u + t·edge_v.
///
/// `out.pdf` is the density of the map as it was computed, so estimates are unbiased whatever the rounding; for
/// spherical and two_triangles it is 1/Ω. Places and directions are right to 2e-6 of the light's diameter as it is
/// seen (two_triangles next to the light: 1e-5), directions also to 4e-7 rad (two_triangles: 1e-6), which is what a
/// float direction can tell, and of unit length to 1e-6.
///
/// two_triangles is the comparison of the paper: as even as spherical, but it tears the square apart at the diagonal,
/// and so spoils stratified variates somewhat. Where another side of one of its triangles becomes the smallest as seen
/// from the point, (u, v) begins to name other directions of that triangle, as in TriangleMap::spherical.
///
/// Cost: spherical 7 to 10 times area sampling at one sample a point, three to four at 16; two_triangles 13 to 20 times
/// at one, five to seven at 16. The README's tables have all.
///
/// Source: Ureña, Fajardo and King 2013, in the form that src/rectangle_strips.h and src/rectangle_map.h explain; for
/// two_triangles Arvo 1995, in that of src/two_triangles_map.h and src/spherical_triangle.h.
HATBOX_API void sample(const Rectangle& light, RectangleMap map, Points points, Variates variates, Samples out);

/// The density, per steradian, with which `sample` picks each of the k·n `directions` (unit length, not checked): 0 for
/// one that misses the light. The hit test has a margin of 8 ulp (two_triangles: 16) of the direction, in favour of a
/// hit. `out` has k·n elements. What `sample` returned is met to 1e-5, as far as a float direction can tell.
///
/// Cost at one a point, in samples by `area`: 6 to 7; two_triangles 12, `area` 3 to 4.
HATBOX_API void pdf(const Rectangle& light, RectangleMap map, Points points, Directions directions,
                    std::span<float> out);

/// The density, per steradian, with which `sample` picks the direction to each of the k·n `places`: 0 outside the
/// light. What `sample` returned with the place is met to 1e-5. For far lights the better of the two: a float direction
/// cannot resolve what lies within 1e-7 rad.
///
/// Cost at one a point, in samples by `area`: 5 to 6; two_triangles 9 to 10, `area` 1.
HATBOX_API void pdf(const Rectangle& light, RectangleMap map, Points points, Places places, std::span<float> out);

/// The (u, v) that `sample` turns into each of the k·n `directions`: -1, -1 for one that misses the light or cannot be
/// sampled. Right to 1e-5 (two_triangles: 1e-4, but next to the diagonal, on either side of which u and v are others)
/// where the light is wide enough for a float direction to tell. `u` and `v` have k·n elements each.
///
/// Cost at one a point, in samples by `area`: 9; two_triangles 15, `area` 4.
HATBOX_API void invert(const Rectangle& light, RectangleMap map, Points points, Directions directions,
                       std::span<float> u, std::span<float> v);

/// The solid angle of the light from each of the n points, in steradians, in (0, 2π]: right to 2e-6, relative. `out`
/// has n elements.
///
/// Cost at one a point, in samples by `area`: 5.
///
/// Source: the strips' areas, differences of arc tangents that do not cancel (src/rectangle_strips.h), where Ureña et
/// al. 2013 have a sum of four angles.
HATBOX_API void solid_angle(const Rectangle& light, Points points, std::span<float> out);

/// What is wrong with a light, beginning with the name of the member; empty if nothing is. Calls throw on a light that
/// does not pass, so hosts without exceptions ask here first.
HATBOX_API std::string_view check(const Rectangle& light) noexcept;

namespace parallel {

/// @{
/// The same calls, the points split into blocks by TBB, in the caller's task arena and isolated from its other tasks.
/// `grain` is the least number of points a block (0: chosen by the library); a job of one block runs in the caller's
/// thread. All threads flush denormals if that does.
HATBOX_API void sample(const Rectangle& light, RectangleMap map, Points points, Variates variates, Samples out,
                       std::size_t grain = 0);
HATBOX_API void pdf(const Rectangle& light, RectangleMap map, Points points, Directions directions,
                    std::span<float> out, std::size_t grain = 0);
HATBOX_API void pdf(const Rectangle& light, RectangleMap map, Points points, Places places, std::span<float> out,
                    std::size_t grain = 0);
HATBOX_API void invert(const Rectangle& light, RectangleMap map, Points points, Directions directions,
                       std::span<float> u, std::span<float> v, std::size_t grain = 0);
HATBOX_API void solid_angle(const Rectangle& light, Points points, std::span<float> out, std::size_t grain = 0);
/// @}

}  // namespace parallel

}  // namespace hatbox
