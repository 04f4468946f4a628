// The cone of directions from a shading point to a light, as a spherical ellipse: what the solid-angle maps need to
// know of it, and the points they make on it. Where the ellipse lies and what it is the image of, its cone knows
// (disk_cone.h).
//
// In the frame x̂_e, ŷ_e (along the larger and the smaller semi-axis) and ẑ_e (its centre) the ellipse is that of
// Guillén et al. 2017, Figure 2. Projected along ẑ_e its rim is (a cos η, b sin η), at the height
//   h(η) = cos β · H(η),  H(η)² = k'² cos² η + sin² η,  k' = cos α/cos β.
#pragma once

#include "unit_square.h"

namespace hatbox::HATBOX_ISA {
namespace {

template <class V>
struct SphericalEllipse {
  using Vector = V;

  Mask<V> valid;  // false in the light's plane and for non-finite points; the rest is then of no use
  V a, b;         // sin α, sin β
  V inverse_ab;   // of use where their product would underflow
  V cos_beta;
  V k2;  // k'²

  V rim_height(const SinCos<V>& eta) const { return cos_beta * sqrt(fma(k2, eta.cos * eta.cos, eta.sin * eta.sin)); }
};

/// A direction of the cone, q = (a x, b y, z)/scale in the ellipse's frame: x² + y² < scale² but for rounding. All are
/// given times the scale, so that nobody has to wait for its inverse: `inwards` is scale · (1 − (x² + y²)/scale²) and
/// must not come from that difference; xx and zz are x²/scale and z²/scale.
template <class V>
struct EllipsePoint {
  V x, y, z;
  V inwards;
  V xx, zz;
  V scale, inverse_scale;
};

/// Of scale 1.
template <class V>
HATBOX_INLINE inline EllipsePoint<V> ellipse_point(V x, V y, V z, V inwards) {
  return {x, y, z, inwards, x * x, z * z, V(1), V(1)};
}

/// A direction that may miss: q = (a x, b y, z) again.
template <class V>
struct EllipseHit {
  V x, y, z;
  Mask<V> inside;
};

/// The angle of a point (x, y), any length, as its cosine and sine; 0 for the centre.
template <class V>
struct AngleAndLength {
  SinCos<V> angle;
  V length;
};

// Nearer to the centre than this the squares are no normal floats, and every angle is as good.
inline constexpr double least_radius = 0x1p-51;

template <class V>
inline AngleAndLength<V> angle_of(V x, V y) {
  const V length = sqrt(fma(x, x, y * y));
  const Mask<V> centre = !(length >= constant<V>(least_radius));
  const V inverse = V(1) / select(centre, V(1), length);
  return {{select(centre, V(0), y * inverse), select(centre, V(1), x * inverse)}, length};
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
