/// \file
/// Views of the caller's arrays. Every call works on n shading points and, where it samples, on k·n samples: sample j
/// of point i lies at [j·n + i]. k is the length of the variates, directions or places over n; n and k may be 0, and
/// then nothing is done. Nothing here owns memory. Outputs may not overlap inputs or each other.
#pragma once

#include <span>

namespace hatbox {

/// n shading points in world space.
struct Points {
  /// @{
  std::span<const float> x, y, z;  ///< world space
  /// @}
};

/// k·n numbers of the unit square. Values outside [0, 1) are clamped into it; a non-finite one spoils its own lane.
struct Variates {
  /// @{
  std::span<const float> u, v;  ///< a coordinate of the square
  /// @}
};

/// k·n directions of unit length (not checked), from the shading point towards the light. (As normals, of any length:
/// see `equiangular::clip`.)
struct Directions {
  /// @{
  std::span<const float> x, y, z;  ///< world space
  /// @}
};

/// k·n places on the light; for a disk (see `axes`) and an ellipse centre + s·axis_u + t·axis_v, so s² + t² <= 1.
struct Places {
  /// @{
  std::span<const float> s, t;  ///< in units of the light's axes, edges or sides: see `sample` of that light
  /// @}
};

/// What `sample` writes, k·n numbers each. An empty span is not written (nor computed, where that saves work).
/// A lane that cannot be sampled gets 0 in every output.
struct Samples {
  /// @{
  std::span<float> x = {}, y = {}, z = {};  ///< unit direction from the shading point to the light
  /// @}
  std::span<float> distance = {};  ///< from the shading point to the light along it, world units; 0 below 1e-38
  std::span<float> pdf = {};       ///< density of the direction, per steradian
  std::span<float> s = {};         ///< place on the light, see Places
  std::span<float> t = {};         ///< place on the light, see Places
  std::span<float> cosine = {};    ///< at the light, signed: > 0 when seen from the side of its normal
};

}  // namespace hatbox
