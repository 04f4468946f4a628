// The area of a spherical ellipse between the end of its major axis and the angle η, by Carlson's integrals (Guillén et
// al. 2017, eq. 16-19): exact for every ellipse, and dear. The paper's radial map inverts it for every sample
// (radial_carlson_map.h); eta_hybrid.h where nothing cheaper will do.
//
// In the angle η of spherical_ellipse.h, with tan φ = (b/a) tan η, tan ϕ = tan η/k' and q = k'² (cos²η + cos²β sin²η),
// eq. 19 is
//   Ω_r = φ − c Π(n; ϕ|m) = φ − atan(h tan φ) + ab k' cos α/3 sin³η R_J(k'² cos²η, k'², k'² cos²η + sin²η, q)
// by DLMF 19.21.12, and the difference of angles, whose tangent is (1 − h) tan φ/(1 + h tan²φ), that of
//   ab (cos²η + (b/a)² sin²η) sin η cos η/((1 + h)(cos²η + h (b/a)² sin²η)).
#pragma once

#include "carlson_map.h"

namespace hatbox::HATBOX_ISA {
namespace {

/// Made once a point.
template <class V>
class SectorArea {
 public:
  /// Of the lanes that are `wanted`, if theirs is an ellipse that R_J can do.
  HATBOX_INLINE SectorArea(const SphericalEllipse<V>& cone, Mask<V> wanted) : cone_(cone) {
    const V b_over_a = cone.b / cone.a;
    ratio2_ = b_over_a * b_over_a;
    const V cos2_alpha = cone.k2 * cone.cos_beta * cone.cos_beta;
    valid_ = wanted && cone.valid && (min(cos2_alpha, ratio2_) >= constant<V>(smallest_));
  }

  /// Ω_r/(ab), of the η in the first quadrant whose rim height is h.
  HATBOX_INLINE V operator()(const SinCos<V>& eta, V h) const {
    const V cos2 = eta.cos * eta.cos, sin2 = eta.sin * eta.sin;
    const V wide = fma(ratio2_, sin2, cos2);
    const V x = wide * eta.sin * eta.cos / ((V(1) + h) * fma(h * ratio2_, sin2, cos2));
    const V k2 = cone_.k2;
    const V third =
        duplicate_rj(valid_, k2 * cos2, k2, fma(k2, cos2, sin2), k2 * fma(cone_.cos_beta * cone_.cos_beta, sin2, cos2));
    return fma(constant<V>(1.0 / 3) * k2 * cone_.cos_beta * (sin2 * eta.sin), third, atan_by_ab(cone_, x));
  }

  /// The whole first quadrant's: Ω/(4ab).
  HATBOX_INLINE V quadrant() const { return (*this)({V(1), V(0)}, cone_.cos_beta); }

  Mask<V> valid() const { return valid_; }

 private:
  static constexpr double smallest_ = 0x1p-110;  // cos²α and (b/a)², so that R_J stays in range

  SphericalEllipse<V> cone_;
  Mask<V> valid_;
  V ratio2_;  // (b/a)²
};

}  // namespace
}  // namespace hatbox::HATBOX_ISA
