// DiskMap::parallel_carlson: the parallel map of Guillén et al. 2017, §3.2, by Carlson's integrals, inverted by
// Newton's method for every sample. u picks a slice through the ellipse's major axis, v a place along it.
//
// With sin φ_p = sin β sin ζ, C = cos²ζ, S = sin²ζ, A = cos²α, B = cos²β, D_α = C + A S and D_β = C + B S, eq. 9 and 11
// become
//   h_p = a cos ζ/√D_α,  dΩ_p⁺/dζ = 2ab C/√(D_α D_β)
// Counted from the end, in ψ = π/2 − ζ, this is the second of the paper's two integrals alone, a positive term that is
// right to a few ulp at the tip too:
//   Ω_p⁺(π/2) − Ω_p⁺(ζ) = 2ab cos³ζ/3 · A/√B · R_J(A S, D_α, k'² D_β; A)
#pragma once

#include "carlson_map.h"

namespace hatbox::HATBOX_ISA {
namespace {

/// ∛x, right to 1e-5 for 2^-25 <= x <= 1: x^(1/4 + 1/16 + 1/64), then Newton.
template <class V>
HATBOX_INLINE inline V cube_root(V x) {
  const V quarter = sqrt(sqrt(x));
  const V sixteenth = sqrt(sqrt(quarter));
  V root = V(0.955f) * quarter * (sixteenth * sqrt(sqrt(sixteenth)));
  for (int step = 0; step < 2; ++step) root = constant<V>(1.0 / 3) * fma(V(2), root, x / (root * root));
  return root;
}

template <class V>
class DiskParallelCarlson {
 public:
  HATBOX_INLINE DiskParallelCarlson(const DiskLight<V>& light, V x, V y, V z) : cone_(light, x, y, z) {
    cos2_beta_ = cone_.cos_beta * cone_.cos_beta;
    cos2_alpha_ = cone_.k2 * cos2_beta_;
    valid_ = cone_.valid && (cos2_alpha_ * cos2_beta_ >= constant<V>(smallest_));
    half_ = rest_of(Slice(*this, {V(0), V(1)}));
    density_ = V(0.25) * cone_.inverse_ab / half_;
    valid_ = honest(valid_, density_);
    tip_ = cube_root(max(constant<V>(4 / pi) * half_ * sqrt(cos2_alpha_ * cos2_beta_), V(0x1p-25f)));
  }

  HATBOX_INLINE LightSample<V> sample(V u, V v) const {
    const V across = fma(V(2), clamp_variate(u), V(-1));
    const V along = clamp_variate(v);
    const Slice at(*this, inverse(abs(across)));
    const V w = fma(V(2), along, V(-1));
    const V eta_cos = at.zeta.cos * at.inverse_root_alpha;
    const V one_minus_w2 = V(4) * along * (V(1) - along);
    // 1 − h², h = a w cos η, as a sum of positive terms
    const V eta_cos2 = eta_cos * eta_cos,
            eta_sin2 = cos2_alpha_ * at.sin2 * at.inverse_root_alpha * at.inverse_root_alpha;
    const V radius = sqrt(fma(cone_.a * cone_.a, fma(one_minus_w2, eta_cos2, eta_sin2), cos2_alpha_));

    LightSample<V> out;
    out.pdf = density_;
    const V y = radius * copysign(at.zeta.sin, across);
    cone_.emit(ellipse_point(w * eta_cos, y, radius * sqrt(at.beta), one_minus_w2 * at.cos2), out);
    out.valid = valid_ && is_finite(given(u, v) + out.distance);
    return out;
  }

  V pdf_of_place(const Place<V>& place) const { return select(valid_ && on_unit_disk(place), density_, V(0)); }

  V pdf_of_direction(const V (&direction)[3]) const {
    return select(valid_ && cone_.hit(direction).inside, density_, V(0));
  }

  Square<V> invert(const V (&direction)[3]) const {
    const EllipseHit<V> q = cone_.hit(direction);
    const V b_y = cone_.b * q.y;
    const V sin = min(abs(q.y) / sqrt(fma(q.z, q.z, b_y * b_y)), V(1));
    const Slice at(*this, {sin, sqrt((V(1) - sin) * (V(1) + sin))});
    const V share = V(0.5) - V(0.5) * min(rest_of(at) / half_, V(1));
    const V eta_cos = at.zeta.cos * at.inverse_root_alpha;
    const V w = max(min(q.x / max(eta_cos, constant<V>(smallest_normal<V>)), V(1)), V(-1));
    const Mask<V> hit = q.inside && valid_;
    return {select(hit, clamp_variate(V(0.5) + copysign(share, q.y)), V(-1)),
            select(hit, clamp_variate(fma(V(0.5), w, V(0.5))), V(-1))};
  }

 private:
  static constexpr int newton_steps = 2;
  static constexpr double smallest_ = 0x1p-110;  // cos²α cos²β, so that R_J stays in range

  struct Slice {
    HATBOX_INLINE Slice(const DiskParallelCarlson& map, const SinCos<V>& at)
        : zeta(at),
          sin2(at.sin * at.sin),
          cos2(at.cos * at.cos),
          alpha(fma(map.cos2_alpha_, sin2, cos2)),
          beta(fma(map.cos2_beta_, sin2, cos2)),
          inverse_root_alpha(V(1) / sqrt(alpha)) {}

    SinCos<V> zeta;
    V sin2, cos2, alpha, beta;  // S, C, D_α, D_β
    V inverse_root_alpha;
  };

  /// What slices from ζ to the end hold, over 2ab.
  HATBOX_INLINE V rest_of(const Slice& at) const {
    const V third = duplicate_rj(valid_, cos2_alpha_ * at.sin2, at.alpha, cone_.k2 * at.beta, cos2_alpha_);
    return constant<V>(1.0 / 3) * (cone_.k2 * cone_.cos_beta) * (at.cos2 * at.zeta.cos) * third;
  }

  HATBOX_INLINE static SinCos<V> sincos_off_end(V psi) {
    const Mask<V> far = psi > constant<V>(pi / 4);
    const SinCos<V> octant = sincos_octant(constant<V>(4 / pi) * select(far, constant<V>(pi / 2) - psi, psi));
    return {select(far, octant.sin, octant.cos), select(far, octant.cos, octant.sin)};
  }

  /// Eq. 13 for the half of φ_p >= 0, in ψ = π/2 − ζ. A plane disk has ψ − sin ψ cos ψ = π/2 (1 − fraction): ψ is
  /// ∛(1 − fraction) times a polynomial fitted for this file (4e-5). The start is between that and the even shares of a
  /// disk that fills the sky, so that ψ³ is right at the tip; two steps are then exact to float, three no better.
  HATBOX_INLINE SinCos<V> inverse(V fraction) const {
    const V rest = V(1) - fraction;
    const V root = cube_root(max(rest, V(0x1p-25f)));
    constexpr double fit[] = {0.0437476006745, -0.0243266171949, 0.0661136748667, 0.154464935798, 1.33072814349};
    V polynomial = constant<V>(fit[0]);
    for (int i = 1; i < 5; ++i) polynomial = fma(polynomial, root * root, constant<V>(fit[i]));
    V psi = fma(tip_, root * polynomial, (V(1) - tip_) * (constant<V>(pi / 2) * rest));
    for (int step = 0; step < newton_steps; ++step) {
      const Slice at(*this, sincos_off_end(psi));
      const V residual = fma(rest, half_, -rest_of(at));
      const V forward = psi + residual * (sqrt(at.alpha * at.beta) / at.cos2);
      psi = min(max(min(forward, V(2) * psi), V(0.5) * psi), constant<V>(pi / 2));
    }
    return sincos_off_end(psi);
  }

  DiskCone<V> cone_;
  Mask<V> valid_;
  V cos2_alpha_, cos2_beta_;
  V half_;  // Ω/(4ab)
  V density_;
  V tip_;  // ψ at the tips, against a plane disk's
};

}  // namespace
}  // namespace hatbox::HATBOX_ISA
