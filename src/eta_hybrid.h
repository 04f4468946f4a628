// The area-preserving map in the angle η of eta_series.h, also where the rim has a kink: h(η) turns at the ends of the
// major axis, η = 0 and π, within an angle of k', which a series of six terms cannot follow when k' is small. So it is
// next to the tips of narrow ellipses, and next to any rim.
//
// There η(θ) is found from the exact area Θ(η) of sector_area.h, by one step from the series' answer η₀:
//   η = η₀ + r (1 + h) (1 + ½ r h'),  r = Θ(η) − Θ(η₀),
// Taylor's polynomial of order two of η over Θ, since dη/dΘ = 1 + h. The series is within 2.5e-3 of η, so that the next
// term is below 3e-9 rad, and 1.1e-7 of the density, for k' from 1e-6 up: the density reported is the exact map's, 1/Ω.
// Newton's step, without the last factor, leaves 5e-5 of it.
//
// Which lanes take it, their own k' says. The series alone strays from 1/Ω by 4e-5 at most for k' = 0.4, by 2.5e-4 for
// 0.3, by 6e-2 for 0. Packets that have no such lane are spared the rest: of W1 all but 2 in 100 of eight lanes at 1
// : 10. Next to the light, where most packets have one, a sample costs one and a half to three times as much. A call of
// a function that is not inlined, to keep all this out of the way, costs more than it saves.
//
// Rejected: the series of θ − η in the angle χ of tan η = κ tan χ, which spreads the tips. The kink asks for a κ near
// k', the middle for one near 1: the best, about the cube root of k', leaves 5e-4 with eight terms for
// k' = 0.1 and 1e-2 for 0.01, with sixteen 2e-6 and 1e-3.
#pragma once

#include "eta_series.h"
#include "sector_area.h"

namespace hatbox::HATBOX_ISA {
namespace {

/// In the place of EtaSeries, for lights with a `ratio` of their axes. A circle's is left to the series, as a disk's
/// is.
template <class V>
class EtaHybrid {
 public:
  template <class Light>
  HATBOX_INLINE EtaHybrid(const Light& light, const SphericalEllipse<V>& cone)
      : series_(light, cone),
        cone_(cone),
        area_(cone, cone.k2 < select(V(light.ratio) < V(1), constant<V>(kink_ * kink_), V(0))),
        quadrant_(V(1)) {
    if (any(area_.valid())) quadrant_ = area_.quadrant();
  }

  HATBOX_INLINE AngleShift<V> operator()(const SinCos<V>& theta) const {
    const AngleShift<V> smooth = series_(theta);
    if (!any(area_.valid())) return smooth;
    const AngleShift<V> exact = refined(theta, smooth.shift);
    return {select(area_.valid(), exact.shift, smooth.shift), select(area_.valid(), exact.slope, smooth.slope)};
  }

  UniformAngle<V> uniform_angle(const SinCos<V>& eta) const {
    const UniformAngle<V> smooth = series_.uniform_angle(eta);
    if (!any(area_.valid())) return smooth;
    const UniformAngle<V> exact = exact_uniform_angle(eta);
    const auto choose = [&](V yes, V no) { return select(area_.valid(), yes, no); };
    return {{choose(exact.angle.sin, smooth.angle.sin), choose(exact.angle.cos, smooth.angle.cos)},
            choose(exact.slope, smooth.slope)};
  }

 private:
  static constexpr double kink_ = 0.4;  // the largest k' of one

  static SinCos<V> first_quadrant(const SinCos<V>& angle) { return {abs(angle.sin), abs(angle.cos)}; }

  /// As a share of the first quadrant.
  static V fraction(const SinCos<V>& angle) {
    const Mask<V> flat = angle.cos > angle.sin;
    const V major = select(flat, angle.cos, angle.sin), minor = select(flat, angle.sin, angle.cos);
    const V near = constant<V>(2 / pi) * atan_unit(minor / major);
    return select(flat, near, V(1) - near);
  }

  /// Into the quadrant, if rounding led out of it.
  HATBOX_INLINE static SinCos<V> moved(const SinCos<V>& theta, V shift) {
    const SinCos<V> eta = rotate(theta, sincos_small(shift));
    return {max(eta.sin, V(0)), max(eta.cos, V(0))};
  }

  /// dη/dθ at an η.
  V slope(V h) const { return constant<V>(2 / pi) * quadrant_ * (V(1) + h); }

  HATBOX_INLINE AngleShift<V> refined(const SinCos<V>& theta, V start) const {
    const SinCos<V> folded = first_quadrant(theta);
    const V side = copysign(V(1), theta.sin * theta.cos);
    const V shift = side * start;
    const SinCos<V> eta = moved(folded, shift);
    const V h = cone_.rim_height(eta);
    const V rest = fma(fraction(folded), quadrant_, -area_(eta, h));
    const V bend = cone_.cos_beta * cone_.cos_beta * (V(1) - cone_.k2) * (eta.sin * eta.cos) / h;  // h'
    const V step = rest * (V(1) + h) * fma(V(0.5) * rest, bend, V(1));
    const V better = side * max(min(shift + step, constant<V>(0.2)), constant<V>(-0.2));
    return {better, slope(cone_.rim_height(rotate(theta, sincos_small(better))))};
  }

  UniformAngle<V> exact_uniform_angle(const SinCos<V>& eta) const {
    const V h = cone_.rim_height(eta);
    const V share = min(area_(first_quadrant(eta), h) / quadrant_, V(1));
    const SinCos<V> theta = sincos_quadrant(V(2) * share);
    return {{copysign(theta.sin, eta.sin), copysign(theta.cos, eta.cos)}, slope(h)};
  }

  EtaSeries<V> series_;
  SphericalEllipse<V> cone_;
  SectorArea<V> area_;
  V quadrant_;  // Θ(π/2)
};

}  // namespace
}  // namespace hatbox::HATBOX_ISA
