// The solid-angle maps from the centre outwards, ld_radial and radial (Guillén et al. 2017, §3.3), over any cone whose
// spherical ellipse is known (disk_cone.h) and any area-preserving map of its angle (eta_series.h,
// eta_hybrid.h, eta_table.h).
//
// With t = r² the share of the way from the centre direction (t = 0) to the rim (t = 1), equal in solid angle (eq. 22):
//   z = (1 − t) + t h(η),  S² = t (1 + z)/(1 + h),  q = (a S cos η, b S sin η, z)
// so that 1 − S² = (1 − t) ((1 − t) + h (1 + t))/(1 + h). All of these are made times 1 + h, by which nothing then is
// divided on the way to the direction.
#pragma once

#include "disk_cone.h"
#include "eta_series.h"

namespace hatbox::HATBOX_ISA {
namespace {

/// Made once a point; its samples and queries share that.
/// Chart takes the unit square to the unit disk: ConcentricChart for ld_radial, PolarChart for radial.
template <class Cone, class AngleMap, class Chart>
class RadialMap {
 public:
  using V = typename Cone::Vector;

  template <class Light>
  HATBOX_INLINE RadialMap(const Light& light, V x, V y, V z) : cone_(light, x, y, z), angle_map_(light, cone_) {}

  HATBOX_INLINE LightSample<V> sample(V u, V v) const {
    const Polar<V> polar = Chart::forward(u, v);
    const V t = polar.radius * polar.radius;
    const auto [shift, slope] = angle_map_(polar.angle);
    const SinCos<V> eta = rotate(polar.angle, sincos_small(shift));
    const V h = cone_.rim_height(eta);
    const V one_plus_h = V(1) + h;
    const V shared = V(1) / (one_plus_h * slope);
    const V one_minus_t = V(1) - t;
    const V z = fma(t, h, one_minus_t), one_plus_z = V(1) + z;
    const V S = polar.radius * sqrt(one_plus_z * one_plus_h);
    EllipsePoint<V> q;
    q.x = S * eta.cos;
    q.y = S * eta.sin;
    q.z = one_plus_h * z;
    q.inwards = one_minus_t * fma(h, V(1) + t, one_minus_t);
    q.xx = t * one_plus_z * (eta.cos * eta.cos);
    q.zz = q.z * z;
    q.scale = one_plus_h;
    q.inverse_scale = shared * slope;

    LightSample<V> out;
    out.pdf = density() * (one_plus_h * one_plus_h * shared);
    cone_.emit(q, out);
    out.valid = honest(cone_.valid && is_finite(given(u, v) + out.distance), out.pdf);
    return out;
  }

  V pdf_of_place(const Place<V>& place) const { return pdf(cone_.eta_of(place), on_unit_disk(place)); }

  V pdf_of_direction(const V (&direction)[3]) const {
    const EllipseHit<V> q = cone_.hit(direction);
    return pdf(angle_of(q.x, q.y).angle, q.inside);
  }

  Square<V> invert(const V (&direction)[3]) const {
    const EllipseHit<V> q = cone_.hit(direction);
    const auto [eta, S] = angle_of(q.x, q.y);
    const V h = cone_.rim_height(eta);
    const V r = min(min(S, V(1)) * sqrt((V(1) + h) / (V(1) + max(q.z, V(0)))), V(1));
    const Square<V> square = Chart::inverse(Polar<V>{r, angle_map_.uniform_angle(eta).angle});
    const Mask<V> hit = honest(q.inside, density());
    return {select(hit, clamp_variate(square.u), V(-1)), select(hit, clamp_variate(square.v), V(-1))};
  }

 private:
  // In η it is this times 1 + h.
  V density() const { return constant<V>(0.5 / pi) * cone_.inverse_ab; }

  V pdf(const SinCos<V>& eta, Mask<V> hit) const {
    const V p = density() * ((V(1) + cone_.rim_height(eta)) / angle_map_.uniform_angle(eta).slope);
    return select(honest(hit && cone_.valid, p), p, V(0));
  }

  Cone cone_;
  AngleMap angle_map_;
};

struct ConcentricChart {
  template <class V>
  static Polar<V> forward(V u, V v) {
    return concentric(u, v);
  }
  template <class V>
  static Square<V> inverse(const Polar<V>& polar) {
    return concentric_inverse(polar);
  }
};

struct PolarChart {
  template <class V>
  static Polar<V> forward(V u, V v) {
    return plain_polar(u, v);
  }
  template <class V>
  static Square<V> inverse(const Polar<V>& p) {
    return plain_polar_inverse(p);
  }
};

}  // namespace
}  // namespace hatbox::HATBOX_ISA
