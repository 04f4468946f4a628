// DiskMap::radial_carlson: the radial map with its solid angle by Carlson's integrals (sector_area.h), inverted by
// Newton's method for every sample, as its paper has it (Guillén et al. 2017, eq. 16-22). A baseline: radial makes the
// same samples, cheaper.
#pragma once

#include "sector_area.h"

namespace hatbox::HATBOX_ISA {
namespace {

/// Eq. 23 for one quadrant: the share of a quarter turn, and the signs that unfold it again.
template <class V>
struct Quadrant {
  V fraction, sin_sign, cos_sign;

  HATBOX_INLINE static Quadrant of_turn(V turn) {
    const V quarters = V(4) * turn;
    const Mask<V> lower = quarters >= V(2);
    const V rest = select(lower, quarters - V(2), quarters);
    const Mask<V> back = rest > V(1);
    const V sin_sign = select(lower, V(-1), V(1));
    return {select(back, V(2) - rest, rest), sin_sign, select(back, -sin_sign, sin_sign)};
  }
  HATBOX_INLINE V turn() const {
    const V rest = select(sin_sign == cos_sign, fraction, V(2) - fraction);
    return V(0.25) * select(sin_sign < V(0), rest + V(2), rest);
  }
};

template <class V>
class DiskRadialCarlson {
 public:
  HATBOX_INLINE DiskRadialCarlson(const DiskLight<V>& light, V x, V y, V z)
      : cone_(light, x, y, z), area_(cone_, cone_.valid) {
    quadrant_ = area_.quadrant();
    density_ = V(0.25) * cone_.inverse_ab / quadrant_;
    valid_ = honest(area_.valid(), density_);
  }

  HATBOX_INLINE LightSample<V> sample(V u, V v) const {
    const auto quadrant = Quadrant<V>::of_turn(clamp_variate(u));
    const SinCos<V> eta = inverse(quadrant.fraction);
    const V t = clamp_variate(v);
    const V h = cone_.rim_height(eta);
    const V inverse_1_plus_h = V(1) / (V(1) + h);
    const V one_minus_t = V(1) - t;
    const V z = fma(t, h, one_minus_t);
    const V S = sqrt(t * (V(1) + z) * inverse_1_plus_h);
    const V inwards = one_minus_t * fma(h, V(1) + t, one_minus_t) * inverse_1_plus_h;

    LightSample<V> out;
    out.pdf = density_;
    cone_.emit(ellipse_point(quadrant.cos_sign * S * eta.cos, quadrant.sin_sign * S * eta.sin, z, inwards), out);
    out.valid = valid_ && is_finite(given(u, v) + out.distance);
    return out;
  }

  V pdf_of_place(const Place<V>& place) const { return select(valid_ && on_unit_disk(place), density_, V(0)); }

  V pdf_of_direction(const V (&direction)[3]) const {
    return select(valid_ && cone_.hit(direction).inside, density_, V(0));
  }

  /// Ω_r(η) itself: this way needs no Newton.
  Square<V> invert(const V (&direction)[3]) const {
    const EllipseHit<V> q = cone_.hit(direction);
    const auto [eta, S] = angle_of(q.x, q.y);
    const V h = cone_.rim_height(eta);
    const V share = area_({abs(eta.sin), abs(eta.cos)}, h) / quadrant_;
    const Quadrant<V> quadrant = {min(share, V(1)), copysign(V(1), eta.sin), copysign(V(1), eta.cos)};
    const V r = min(S, V(1));
    const V t = r * r * ((V(1) + h) / (V(1) + max(q.z, V(0))));
    const Mask<V> hit = q.inside && valid_;
    return {select(hit, clamp_variate(quadrant.turn()), V(-1)), select(hit, clamp_variate(t), V(-1))};
  }

 private:
  static constexpr int newton_steps = 2;

  /// Eq. 21 in η, where the derivative 1/(1 + h) is within a factor 2 of constant. The start is the inverse of the
  /// series 1/(1 + h) ∝ 1 + A cos 2η to second order.
  HATBOX_INLINE SinCos<V> inverse(V fraction) const {
    const SinCos<V> theta = sincos_quadrant(V(2) * fraction);
    const V cos_alpha = cone_.cos_beta * sqrt(cone_.k2);
    const V A = (cone_.cos_beta - cos_alpha) / (V(2) + cone_.cos_beta + cos_alpha);
    const V cos_2theta = fma(V(-2) * theta.sin, theta.sin, V(1));
    V shift = theta.sin * theta.cos * A * fma(A, cos_2theta, V(-1));
    SinCos<V> eta = moved(theta, shift);
    for (int step = 0; step < newton_steps; ++step) {
      const V h = cone_.rim_height(eta);
      shift = fma(fma(fraction, quadrant_, -area_(eta, h)), V(1) + h, shift);
      shift = max(min(shift, constant<V>(0.2)), constant<V>(-0.2));
      eta = moved(theta, shift);
    }
    return eta;
  }

  /// Into the quadrant, if the step led out of it.
  HATBOX_INLINE static SinCos<V> moved(const SinCos<V>& theta, V shift) {
    const SinCos<V> eta = rotate(theta, sincos_small(shift));
    return {select(eta.cos < V(0), V(1), max(eta.sin, V(0))), select(eta.sin < V(0), V(1), max(eta.cos, V(0)))};
  }

  DiskCone<V> cone_;
  SectorArea<V> area_;
  Mask<V> valid_;
  V quadrant_;  // Ω/(4ab)
  V density_;
};

}  // namespace
}  // namespace hatbox::HATBOX_ISA
