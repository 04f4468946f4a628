// The lights. Plain structs: no invariants are kept; `check` (and every call) tells whether one is valid.
#pragma once

namespace hatbox {

struct Vec3 {
  float x, y, z;
};

/// A flat disk. It emits to both sides; one-sidedness is the renderer's choice, from `Samples::cosine`.
///
/// Valid if all numbers are finite, `normal` is not zero and `radius` > 0.
struct Disk {
  Vec3 center;   ///< world space
  Vec3 normal;   ///< any length but zero
  float radius;  ///< world units
};

}  // namespace hatbox
