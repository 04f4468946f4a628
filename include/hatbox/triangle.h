/// \file
/// Triangle lights: sample, pdf, invert and solid angle for whole arrays of shading points.
///
/// All calls are thread-safe and allocate nothing (those of `parallel`: what TBB does). They throw
/// std::invalid_argument, before anything is written, if spans disagree in length, the light is not one (see `check`),
/// `map` is no TriangleMap or HATBOX_ISA no instruction set (isa.h); the message names the argument and its value. A
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

/// How (u, v) becomes a direction to the triangle. Both are bijections of the square onto the triangle as it is seen.
enum class TriangleMap {
  area,       ///< uniform in area (Heitz 2019): low distortion. Cheapest, noisy close by
  spherical,  ///< uniform in solid angle (Arvo 1995), polar: u turns about a vertex, v goes from it to the other side
};

/// Samples k directions from each of n points: sample j of point i lies at [j·n + i] of `variates` and `out`. The k
/// samples of a point share its set-up, so that many cost less than their number. A place (s, t) is
/// a + s·(b − a) + t·(c − a).
///
/// `out.pdf` is the true density of the map: for `spherical` 1/Ω, the same for all directions. Samples are right to
/// 2e-6 of the light's angular diameter, by their place (s, t) also where a float direction cannot resolve that;
/// directions are of unit length to 1e-6, and places are on the triangle to 1e-6.
///
/// `spherical` turns about one end of the smallest side as seen from the point. Where another side becomes the
/// smallest, (u, v) begins to name other directions; for each point the map is one continuous bijection.
///
/// Cost: spherical seven to nine times area sampling at one sample a point, three to five at 16. The README's tables
/// have all.
///
/// Source: Arvo 1995, "Stratified Sampling of Spherical Triangles", in the form that src/spherical_triangle.h explains.
HATBOX_API void sample(const Triangle& light, TriangleMap map, Points points, Variates variates, Samples out);

/// The density, per steradian, with which `sample` picks each of the k·n `directions` (unit length, not checked): 0 for
/// one that misses the light. The hit test has a margin of 16 ulp of the direction, in favour of a hit. `out` has k·n
/// elements. What `sample` returned is met to 1e-5, as far as a float direction can tell.
///
/// Cost at one a point, in samples by `area`: 7 to 8; `area` 5.
HATBOX_API void pdf(const Triangle& light, TriangleMap map, Points points, Directions directions, std::span<float> out);

/// The density, per steradian, with which `sample` picks the direction to each of the k·n `places`: 0 outside the
/// light. What `sample` returned with the place is met to 1e-5. For far lights the better of the two: a float direction
/// cannot resolve what lies within 1e-7 rad.
///
/// Cost at one a point, in samples by `area`: 6; `area` 1.
HATBOX_API void pdf(const Triangle& light, TriangleMap map, Points points, Places places, std::span<float> out);

/// The (u, v) that `sample` turns into each of the k·n `directions`: -1, -1 for one that misses the light or cannot be
/// sampled. Right to 1e-4 where the light is wide enough, and the direction clear enough of the vertex that the map
/// turns about, for a float direction to tell. `u` and `v` have k·n elements each.
///
/// Cost at one a point, in samples by `area`: 9 to 11; `area` 5 to 6.
HATBOX_API void invert(const Triangle& light, TriangleMap map, Points points, Directions directions, std::span<float> u,
                       std::span<float> v);

/// The solid angle of the light from each of the n points, in steradians, in (0, 2π), or 0: right to 2e-6, relative,
/// plus what the rounding of the inputs makes of themselves. `out` has n elements.
///
/// Cost at one a point, in samples by `area`: 5.
///
/// Source: two sides and their angle, in half angles (src/spherical_triangle.h).
HATBOX_API void solid_angle(const Triangle& light, Points points, std::span<float> out);

/// What is wrong with a light, beginning with the name of the member; empty if nothing is. Calls throw on a light that
/// does not pass, so hosts without exceptions ask here first.
HATBOX_API std::string_view check(const Triangle& light) noexcept;

namespace parallel {

/// @{
/// The same calls, the points split into blocks by TBB, in the caller's task arena and isolated from its other tasks.
/// `grain` is the least number of points a block (0: chosen by the library); a job of one block runs in the caller's
/// thread. All threads flush denormals if that does.
HATBOX_API void sample(const Triangle& light, TriangleMap map, Points points, Variates variates, Samples out,
                       std::size_t grain = 0);
HATBOX_API void pdf(const Triangle& light, TriangleMap map, Points points, Directions directions, std::span<float> out,
                    std::size_t grain = 0);
HATBOX_API void pdf(const Triangle& light, TriangleMap map, Points points, Places places, std::span<float> out,
                    std::size_t grain = 0);
HATBOX_API void invert(const Triangle& light, TriangleMap map, Points points, Directions directions, std::span<float> u,
                       std::span<float> v, std::size_t grain = 0);
HATBOX_API void solid_angle(const Triangle& light, Points points, std::span<float> out, std::size_t grain = 0);
/// @}

}  // namespace parallel

}  // namespace hatbox
