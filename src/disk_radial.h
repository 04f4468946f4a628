// DiskMap::ld_radial and radial: uniform in solid angle over the spherical ellipse of the disk, from the centre
// outwards (Guillén et al. 2017, §3.3), in the angle η of eta_series.h.
//
// With t = r² the share of the way from the centre direction (t = 0) to the rim (t = 1), equal in solid angle (eq. 22):
//   z = (1 − t) + t h(η),  S² = t (1 + z)/(1 + h),  q = (a S cos η, b S sin η, z)
// in the frame x̂_e = n̂ × t̂, ŷ_e (away from the shading point's foot), ẑ_e (the ellipse's centre).
#pragma once

#include "disk_hit.h"
#include "disk_sample.h"
#include "eta_series.h"

namespace hatbox::HATBOX_ISA {
namespace {

/// A direction inside the cone, as the maps see it: q = (a S cos η, b S sin η, z).
template <class V>
struct EllipsePoint {
  SinCos<V> eta;
  V S, z;
};

/// How near the disk's plane a direction lies: cosine = m_n·value, distance = |h|/(m_n·value).
template <class V>
struct Descent {
  V value, inverse;
};

// The plain form z − κ cos β S sin η cancels where a ray grazes the far half of the disk. Times its conjugate it is
//   cos²β k'² (b² + K cos²η)/(1 − h²) + (z² − h²)(b² + K)/(1 − h²),  K = κ² cos²β,
// a sum of positive terms.
template <class V>
HATBOX_INLINE inline Descent<V> descent(const DiskCone<V>& cone, const EllipsePoint<V>& q, V one_minus_t, V h,
                                        V inverse_1_plus_h) {
  const V tilt = cone.kappa * cone.cos_beta * q.S * q.eta.sin;
  const V conjugate = q.z + abs(tilt);
  // Over a², so that the far light does not underflow; for the grazing one the floor keeps 0/0 at a quotient of 1.
  constexpr double floor = smallest_normal<V> / std::numeric_limits<Scalar<V>>::epsilon();
  const V b2 = fma(cone.b_over_a, cone.b_over_a, constant<V>(floor));
  const V K = cone.a * cone.d * cone.cos_beta;  // √K/a
  const V K2 = K * K;
  const V cos2 = q.eta.cos * q.eta.cos;
  const V rho2 = fma(b2, q.eta.sin * q.eta.sin, cos2);  // (1 − h²)/a²
  const V at_rim = cone.cos_beta * cone.cos_beta * cone.k2 * fma(K2, cos2, b2);
  const V inwards = one_minus_t * (q.z + h) * inverse_1_plus_h * (cone.a * cone.a) * (b2 + K2);
  const V product = fma(rho2, inwards, at_rim);
  const Mask<V> away = tilt > V(0);
  const V numerator = select(away, product, conjugate);
  const V denominator = select(away, rho2 * conjugate, V(1));
  return {numerator / denominator, denominator / numerator};
}

/// Made once a point; its samples and queries share that.
/// Chart is ConcentricChart for ld_radial, PolarChart for radial.
template <class V, class Chart>
class RadialMap {
 public:
  HATBOX_INLINE RadialMap(const Constants<V>& light, V x, V y, V z)
      : light_(light), cone_(disk_cone(light, x, y, z)), series_(eta_series(cone_)) {}

  HATBOX_INLINE DiskSample<V> sample(V u, V v) const {
    const Polar<V> polar = Chart::forward(u, v);
    const V t = polar.radius * polar.radius;
    const auto [shift, slope] = along(polar.angle);
    EllipsePoint<V> q;
    q.eta = rotate(polar.angle, sincos_small(shift));
    const V h = rim_height(cone_, q.eta.cos * q.eta.cos, q.eta.sin * q.eta.sin);
    const V one_plus_h = V(1) + h;
    const V shared = V(1) / (one_plus_h * slope);
    const V one_minus_t = V(1) - t;
    q.z = fma(t, h, one_minus_t);
    q.S = polar.radius * sqrt((V(1) + q.z) * (shared * slope));

    DiskSample<V> out;
    out.pdf = density() * (one_plus_h * one_plus_h * shared);
    place(q, descent(cone_, q, one_minus_t, h, shared * slope), out);
    out.valid = honest(cone_.valid && is_finite(u + v) && is_finite(out.distance), out.pdf);
    return out;
  }

  V pdf_of_place(const Place<V>& place) const {
    const V tau = fma(place.s, cone_.t_u, place.t * cone_.t_v);
    const V sigma = fma(place.t, cone_.t_u, -(place.s * cone_.t_v));
    // `place` below, inverted: tan η = y/(k' x) = (τ + κ)/σ.
    return pdf(sigma, tau + cone_.kappa, on_disk(place.s, place.t));
  }

  V pdf_of_direction(const V (&direction)[3]) const {
    const EllipseHit<V> q = ellipse_hit(light_, cone_, direction);
    return pdf(q.x, q.y, q.inside);
  }

  Square<V> invert(const V (&direction)[3]) const {
    const EllipseHit<V> q = ellipse_hit(light_, cone_, direction);
    const EllipsePoint<V> point = ellipse_point(q.x, q.y);
    const Uniform uniform = uniform_angle(point.eta);
    const V h = rim_height(cone_, point.eta.cos * point.eta.cos, point.eta.sin * point.eta.sin);
    const V r = min(min(point.S, V(1)) * sqrt((V(1) + h) / (V(1) + max(q.z, V(0)))), V(1));
    const Square<V> square = Chart::inverse(Polar<V>{r, uniform.angle});
    const Mask<V> hit = honest(q.inside, density());
    return {select(hit, clamp_variate(square.u), V(-1)), select(hit, clamp_variate(square.v), V(-1))};
  }

 private:
  struct Uniform {
    SinCos<V> angle;  // θ
    V slope;          // dη/dθ
  };

  // In η it is this times 1 + h.
  V density() const { return constant<V>(0.5 / pi) * cone_.inverse_ab; }

  typename EtaSeries<V>::Value along(const SinCos<V>& theta) const {
    const V sin2 = V(2) * theta.sin;
    return series_(fma(-sin2, theta.sin, V(1)), sin2 * theta.cos);
  }

  // η ↦ θ by Newton's method: |η − θ| < 0.15, three steps are exact to float everywhere, and the
  // fourth is for the slope there.
  Uniform uniform_angle(const SinCos<V>& eta) const {
    Uniform out = {eta, V(1)};
    V back = V(0);  // θ − η
    for (int step = 0; step < 4; ++step) {
      const auto [shift, slope] = along(out.angle);
      back = back - (back + shift) / slope;
      out.slope = slope;
      out.angle = rotate(eta, sincos_small(back));
    }
    return out;
  }

  static EllipsePoint<V> ellipse_point(V x, V y) {
    const V S = sqrt(fma(x, x, y * y));
    const Mask<V> centre = !(S >= constant<V>(smallest_normal<V>));
    const V inverse = V(1) / select(centre, V(1), S);
    return {{select(centre, V(0), y * inverse), select(centre, V(1), x * inverse)}, S, V(0)};
  }

  V pdf(V x, V y, Mask<V> hit) const {
    const EllipsePoint<V> q = ellipse_point(x, y);
    const V h = rim_height(cone_, q.eta.cos * q.eta.cos, q.eta.sin * q.eta.sin);
    const V p = density() * ((V(1) + h) / uniform_angle(q.eta).slope);
    return select(honest(hit && cone_.valid, p), p, V(0));
  }

  // Direction, distance and place of q. On the disk its place is a Möbius map of the tangent ellipse's unit disk:
  //   τ = (y − κ)/(1 − κy),  σ = k' x/(1 − κy),  x = cos α S cos η/z,  y = cos β S sin η/z
  // along t̂ and n̂ × t̂. Where κ is near 1 the denominator is small and τ follows better from the distance.
  HATBOX_INLINE void place(const EllipsePoint<V>& q, const Descent<V>& descent, DiskSample<V>& out) const {
    const V q_x = cone_.a * (q.S * q.eta.cos);
    const V S_sin = q.S * q.eta.sin;
    const V q_t = fma(cone_.m_t, q.z, cone_.m_n * (cone_.b * S_sin));
    const V q_n = cone_.m_n * descent.value;
    to_world(light_, fma(q_t, cone_.t_u, -(q_x * cone_.t_v)), fma(q_t, cone_.t_v, q_x * cone_.t_u),
             select(cone_.below, q_n, -q_n), out.direction);
    out.cosine = select(cone_.below, -q_n, q_n);
    const V distance = cone_.height_over_m_n * descent.inverse;
    out.distance = distance * V(light_.radius);
    const V far_tau = fma(-cone_.kappa, q.z, cone_.cos_beta * S_sin) * descent.inverse;
    const V near_tau = fma(distance, q_t, -cone_.d);
    const V tau = select(cone_.kappa < V(0.5), far_tau, near_tau);
    const V sigma = distance * q_x;
    out.place = {fma(tau, cone_.t_u, -(sigma * cone_.t_v)), fma(tau, cone_.t_v, sigma * cone_.t_u)};
  }

  const Constants<V>& light_;
  DiskCone<V> cone_;
  EtaSeries<V> series_;
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
    return polar(u, v);
  }
  template <class V>
  static Square<V> inverse(const Polar<V>& p) {
    return polar_inverse(p);
  }
};

template <class V>
using LdRadialMap = RadialMap<V, ConcentricChart>;
template <class V>
using RadialPolarMap = RadialMap<V, PolarChart>;

}  // namespace
}  // namespace hatbox::HATBOX_ISA
