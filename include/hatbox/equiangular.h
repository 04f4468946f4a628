/// \file
/// Participating media: distances along ray segments, chosen uniformly in the angle under which a pivot sees them
/// (equiangular sampling), and the part of a segment that a one-sided light shines on.
///
/// All calls are thread-safe and allocate nothing (those of `parallel`: what TBB does). They throw
/// std::invalid_argument, before anything is written, if spans disagree in length or HATBOX_ISA is no instruction set
/// (isa.h); the message names which. A lane that cannot be sampled (a number of its segment, pivot or plane not finite,
/// but for t_max; t_min >= t_max; a direction or normal of no normal length; a density that under- or overflows) gets 0
/// in every output; no lane gets NaN or a negative density, and none is touched by another. A lane's bits depend on its
/// own inputs alone: not on its place, on k, on the number of threads, nor (but for sse4_2, see isa.h) on the
/// instruction set. There are no thresholds: scaling all lengths by a power of two scales the results, exactly.
///
/// Errors are those of the result for the inputs as given, however far away the origin or the pivot are, and however
/// the segment passes the pivot: nothing is lost to cancellation.
#pragma once

#include <hatbox/arrays.h>
#include <hatbox/export.h>

#include <cstddef>
#include <span>

namespace hatbox {

/// n segments origin + t·direction, t_min <= t <= t_max, in world space. t is in units of the direction's length, which
/// may be any. t_max may be infinity, as that of a ray that leaves the scene.
struct Segments {
  /// @{
  std::span<const float> x, y, z;  ///< origin
  /// @}

  /// @{
  std::span<const float> dx, dy, dz;  ///< direction
  /// @}

  /// @{
  std::span<const float> t_min, t_max;  ///< ends, in units of the direction's length
  /// @}
};

/// Distances along rays, uniform in the angle about a pivot, in the caller's thread.
namespace equiangular {

/// Samples k distances on each of n segments, about one pivot each: sample j of segment i lies at [j·n + i] of `u`, `t`
/// and `pdf`, which have k·n elements each. The density is proportional to 1/r², r the distance from the pivot, as a
/// point light's in-scattering is.
///
/// `u` is clamped into [0, 1); a non-finite one spoils its own lane. `t` is in [t_min, t_max] and rises with `u`: the
/// probability of a smaller one is `u` to 1e-6, plus what an ulp of `t` makes of it. `pdf`, per unit of t, is that of
/// the `t` returned, to 1e-6.
///
/// On the segment itself a pivot has no such density: one closer to its ray than 2^-32 of its distance from the
/// segment's start, rounded down to a power of two, is taken to be that far beside it (where it is the start, 2^-32 of
/// the segment's length, or, if that is infinite, the lane cannot be sampled). Down there, below 1e-8 of that distance,
/// the bounds above are 1e-4. A pivot on the ray before or behind the segment is as good as any.
///
/// Cost: about an eighth of the textbook's formula in scalar double at one sample a segment, a thirtieth at 16;
/// four times a sample of a disk by DiskMap::area.
///
/// Source: Kulla and Fajardo 2012, in the form that src/equiangular_map.h explains; used so by Guillén et al. 2017, §5.
HATBOX_API void sample(Segments segments, Points pivots, std::span<const float> u, std::span<float> t,
                       std::span<float> pdf);

/// The density, per unit of t, with which `sample` picks each of the k·n distances `t`, to 1e-6: 0 outside the segment,
/// and for one that is not finite. What `sample` returned is met in every bit.
///
/// Cost: nearly that of `sample`.
HATBOX_API void pdf(Segments segments, Points pivots, std::span<const float> t, std::span<float> out);

/// The part of each of the n segments on the side that its normal points to, of the plane through `on_plane` (a light's
/// centre, say) with the normal `normals` (any length but zero): where normal·(x − on_plane) > 0. Right to an ulp of t
/// where the ray is at 1e-7 rad or more to the plane, next to parallel to what twice a float's precision tells. 0, 0
/// where nothing is left, which `sample` takes for a segment that cannot be sampled. `on_plane`, `normals` and the
/// outputs have n elements each; here alone the outputs may be inputs: those of `segments`.
///
/// Cost: a third of that of `sample`.
///
/// Source: the plane's equation along the ray, with products of twice the precision (src/segment_clip.h).
HATBOX_API void clip(Segments segments, Points on_plane, Directions normals, std::span<float> t_min,
                     std::span<float> t_max);

}  // namespace equiangular

/// The calls of hatbox::equiangular on all cores.
namespace parallel::equiangular {

/// @{
/// The same calls, the segments split into blocks by TBB, in the caller's task arena and isolated from its other tasks.
/// `grain` is the least number of segments a block (0: chosen by the library); a job of one block runs in the caller's
/// thread. All threads flush denormals if that does.
HATBOX_API void sample(Segments segments, Points pivots, std::span<const float> u, std::span<float> t,
                       std::span<float> pdf, std::size_t grain = 0);
HATBOX_API void pdf(Segments segments, Points pivots, std::span<const float> t, std::span<float> out,
                    std::size_t grain = 0);
HATBOX_API void clip(Segments segments, Points on_plane, Directions normals, std::span<float> t_min,
                     std::span<float> t_max, std::size_t grain = 0);
/// @}

}  // namespace parallel::equiangular

}  // namespace hatbox
