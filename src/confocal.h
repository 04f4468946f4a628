// The ellipsoid through the shading point that is confocal with an elliptical disk: where the cone of the disk begins.
//
// In the disk's axes, its longer semi-axis being 1 and the shorter r, the quadrics confocal with it are
//   x²/(1 + λ) + y²/(r² + λ) + h²/λ = 1,
// and the tangent cones that a point sees of them all have the same axes: the normals there of the three that pass
// through it (Jacobi 1834). Just one of the three is an ellipsoid, λ > 0. Its normal is the centre direction ẑ_e, and
// √λ the centre's distance along it once the light has been replaced by the section at right angles to ẑ_e.
//
// Its equation is solved by steps each of which is a quadratic equation. With R(λ) = x²/(1 + λ) + y²/(r² + λ) replaced
// by the one pole C/(E + λ) that touches it at λ_k,
//   λ² − B λ − h² E = 0,  B = h² + C − E.
// 1/R is concave, so R is underestimated and so is λ: the steps rise towards the root, ever twice as many digits. For a
// circle the first one is there. With g = (r² + λ_k)/(1 + λ_k), j = λ_k/(1 + λ_k) and W = x² g² + y²
//   E = (x² g² + r² y²)/W,
//   C − E = r² (x² (g + (1 − r²) j) + y²)/W · (x² + y²/r² − 1) + ((1 − r²) j)² x²/W · (x² − 1)
// where both differences are formed without cancellation, since beside the rim they, λ and h are small alike.
#pragma once

#include "disk_cone.h"
#include "ellipse_light.h"

namespace hatbox::HATBOX_ISA {
namespace {

/// From the shading point to the centre of the light. Lengths are in units of the longer semi-axis.
template <class V>
struct EllipseLocal {
  V u, v, height;  // along the longer and the shorter semi-axis and, >= 0, the normal
  V v_over_r;
  V offset;    // u² + v²/r² − 1
  V u_offset;  // u² − 1
};

template <class V>
struct Confocal {
  V lambda, root;  // λ and √λ, of which the second does not underflow
};

// The larger root of λ² − B λ − P = 0, P >= 0, given √(B² + 4P).
template <class V>
HATBOX_INLINE inline V larger_root(V B, V P, V discriminant) {
  const Mask<V> positive = B >= V(0);
  return select(positive, B + discriminant, P + P) / select(positive, V(2), discriminant - B);
}

// √(B² + 4P) where P < B: from 2^50 on that is B, and squares could overflow.
template <class V>
HATBOX_INLINE inline V discriminant_of(V B, V P) {
  return select(abs(B) < constant<V>(0x1p50), sqrt(fma(B, B, V(4) * P)), abs(B));
}

template <class V>
class ConfocalEllipsoid {
 public:
  HATBOX_INLINE ConfocalEllipsoid(const EllipseLight<V>& light, const EllipseLocal<V>& l) : light_(light), l_(l) {
    // On the axis, where x = y = 0, any pole will do. This is far below what the offsets are known to.
    x2_ = max(l.u * l.u, constant<V>(0x1p-46));
    y2_ = l.v * l.v;
    height2_ = l.height * l.height;
    of_rim_ = V(light.ratio2) * l.offset;
    of_tip_ = V(light.flattening2) * l.u_offset;
  }

  HATBOX_INLINE Confocal<V> solve() const {
    // Two underestimates: one touches at 0, the other makes the poles 0 and r² one rather than r² and 1. The larger is
    // within a tenth, whatever the shape; two steps more leave 1e-11, and 1e-6 at the worst of 10^5 points tried.
    const V start = max(step(V(light_.ratio2), V(0)), beyond_the_shorter());
    const V inverse = V(1) / (V(1) + start);
    const V lambda = step((V(light_.ratio2) + start) * inverse, start * inverse);
    const V last_inverse = V(1) / (V(1) + lambda);
    return last_step((V(light_.ratio2) + lambda) * last_inverse, lambda * last_inverse);
  }

 private:
  struct Pole {
    V E, B;
  };

  // Of the quadratic equation, given g and j.
  HATBOX_INLINE Pole pole(V g, V j) const {
    const V g2 = g * g;
    const V inverse_W = V(1) / fma(x2_, g2, y2_);
    const V x = x2_ * inverse_W, y = y2_ * inverse_W;
    const V rim = fma(x, fma(V(light_.flattening), j, g), y), tip = x * (j * j);
    return {fma(x, g2, V(light_.ratio2) * y), fma(rim, of_rim_, fma(tip, of_tip_, height2_))};
  }

  HATBOX_INLINE V step(V g, V j) const {
    const auto [E, B] = pole(g, j);
    const V P = height2_ * E;
    return larger_root(B, P, discriminant_of(B, P));
  }

  // h²/λ + y²/(r² + λ) replaced by (h² + y²)/(E + λ), which touches at infinity.
  HATBOX_INLINE V beyond_the_shorter() const {
    const V C = height2_ + y2_;
    const V E = V(light_.ratio2) * y2_ / (C + constant<V>(smallest_normal<V>));
    const V P = max(fma(E, x2_, C - E), V(0));
    const V B = l_.u_offset + (C - E);
    return larger_root(B, P, discriminant_of(B, P));
  }

  HATBOX_INLINE Confocal<V> last_step(V g, V j) const {
    const auto [E, B] = pole(g, j);
    const V root_E = sqrt(E);
    const V twice = V(2) * (l_.height * root_E);
    const V size = length_with_root(B, twice);
    const Mask<V> positive = B >= V(0);
    const V lambda = larger_root(B, height2_ * E, size);
    const V root = sqrt(select(positive, lambda, V(2) * (size - B)));
    return {lambda, select(positive, root, twice / root)};
  }

  const EllipseLight<V>& light_;
  const EllipseLocal<V>& l_;
  V x2_, y2_, height2_;
  V of_rim_, of_tip_;
};

}  // namespace
}  // namespace hatbox::HATBOX_ISA
