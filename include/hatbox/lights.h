/// \file
/// The lights. Plain structs: no invariants are kept; `check` (and every call) tells whether one is valid.
#pragma once

namespace hatbox {

/// A point or a vector.
struct Vec3 {
  /// @{
  float x, y, z;  ///< world space
  /// @}
};

/// A flat disk. It emits to both sides; one-sidedness is the renderer's choice, from `Samples::cosine`.
///
/// Valid if all numbers are finite, `normal` is not zero and `radius` > 0. One whose radius is no normal float cannot
/// be sampled from anywhere.
struct Disk {
  Vec3 center;   ///< world space
  Vec3 normal;   ///< any length but zero
  float radius;  ///< world units
};

/// A flat elliptical disk: the places center + s·semi_axis_u + t·semi_axis_v with s² + t² <= 1. Either axis may be the
/// longer one. Its normal points along semi_axis_u × semi_axis_v; it emits to both sides.
///
/// Valid if all numbers are finite, the axes are perpendicular, |u·v| <= 1e-4 |u||v|, and neither is zero, longer than
/// the largest float or shorter than 1e-6 of the other.
struct Ellipse {
  Vec3 center;       ///< world space
  Vec3 semi_axis_u;  ///< from the centre to the rim, world units
  Vec3 semi_axis_v;  ///< the other
};

/// A flat rectangle. It emits to both sides; one-sidedness is the renderer's choice, from `Samples::cosine`, which is
/// positive on the side of edge_u × edge_v.
///
/// Valid if all numbers are finite, the lengths of the edges are normal floats, and the edges are perpendicular: the
/// cosine of their angle is at most 1e-4. What the shorter edge has along the longer is ignored.
struct Rectangle {
  Vec3 corner;  ///< world space
  Vec3 edge_u;  ///< from the corner along one side, world units
  Vec3 edge_v;  ///< from the corner along the other
};

/// A flat triangle. It emits to both sides; the cosine is > 0 on the side that (b − a) × (c − a) points to.
///
/// Valid if all numbers are finite, no side is longer than the largest float, and it is at least 2^-24 times as high as
/// its longest side is long.
struct Triangle {
  /// @{
  Vec3 a, b, c;  ///< a vertex, world space
  /// @}
};

}  // namespace hatbox
