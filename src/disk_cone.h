// The cone of directions from a shading point to a disk: the spherical ellipse's semi-axes, centre and frame, without
// cancellation, and the way between its points and the disk's. Lengths are in radii of the disk.
//
// Source: Guillén et al. 2017, eq. 3-5, rearranged. With the height and the rim distances of the shading point
//   ℓ0 = √((d − 1)² + h²),  ℓ1 = √((d + 1)² + h²),  L = ℓ0 ℓ1,  s = d² + h² − 1,  X = d² − h² − 1
// the paper's quantities are
//   sin α = 2/(ℓ0 + ℓ1),  k' = cos α/cos β = 2√L/(ℓ0 + ℓ1),
//   2L sin² β = L − s,  2L cos² β = L + s,  (L − s)(L + s) = 4h²,
//   2L m_t² = L + X,    2L m_n² = L − X,    (L − X)(L + X) = 4d²h²
// and L² = s² + 4h², (ℓ0 + ℓ1)²/4 = 1 + (s + L)/2 give them without the distances themselves.
// where m_t and m_n are the components of the ellipse's centre direction along t̂ (in the disk's plane, from the foot of
// the shading point to the disk's centre) and along the axis. Of each pair the one that would cancel is formed from the
// other. κ = (ℓ1 − ℓ0)/(ℓ1 + ℓ0) = √(1 − k'²) is how far off the disk's centre the centre direction meets it.
#pragma once

#include "compensated.h"
#include "disk_light.h"
#include "light_sample.h"
#include "spherical_ellipse.h"

namespace hatbox::HATBOX_ISA {
namespace {

/// Of a disk: |h| > 0, x̂_e = n̂ × t̂, ŷ_e away from the shading point's foot.
template <class V>
struct DiskCone : SphericalEllipse<V> {
  using Light = DiskLight<V>;

  HATBOX_INLINE DiskCone(const DiskLight<V>& disk, V x, V y, V z);

  /// Direction, distance, cosine and place of a point of the ellipse.
  HATBOX_INLINE void emit(const EllipsePoint<V>& q, LightSample<V>& out) const;

  /// Where a direction of unit length lies. A sampled one is right to a few ulp: what these could move inside, is.
  EllipseHit<V> hit(const V (&direction)[3]) const;

  /// The angle η of the direction to a place on the disk.
  SinCos<V> eta_of(const Place<V>& place) const;

  /// The angle χ of the slice through a place on the disk (parallel_map.h), cos χ >= 0.
  SinCos<V> chi_of(const Place<V>& place) const;

  const DiskLight<V>& light;
  Mask<V> below;  // the shading point lies on the side of −normal
  V height, d;    // |h| and d of the above
  V d2_minus_1;   // d² − 1
  V t_u, t_v;     // t̂ in the disk's own axes; any unit vector for a point on the axis
  V kappa;
  V m_t, m_n;
  V height_over_m_n;
};

/// From a point of the world to the light's centre, in its axes and in radii; of an ellipse, v is in units of its
/// shorter semi-axis, u and n are in those of the longer.
template <class V>
struct DiskLocal {
  V u, v, n;
};

template <class V>
inline const V& shorter_per_unit(const DiskLight<V>& light) {
  return light.per_unit;
}

// A rounded difference, u or v is the exact one of a point or a light an ulp aside, which is all that is known of them.
// The height is not that forgiving: next to the disk's plane the products cancel, and are compensated.
template <class V, class Light>
HATBOX_INLINE inline DiskLocal<V> to_disk(const Light& light, V x, V y, V z) {
  const V up = V(light.inverse_unit);
  const V l[3] = {(V(light.center[0]) - x) * up, (V(light.center[1]) - y) * up, (V(light.center[2]) - z) * up};
  return {along(light.axes[0], l) * V(light.per_unit), along(light.axes[1], l) * V(shorter_per_unit(light)),
          dot(l, light.axes[2], light.normal_lo) * V(light.per_unit)};
}

/// √((L ± x)/(2L)), given x and √((L − x)(L + x))/2: the larger one directly, the other from their product.
template <class V>
struct Halves {
  Mask<V> positive;  // x >= 0, the first is the larger
  V plus, minus;
  V large, inverse_large;
};

template <class V>
HATBOX_INLINE inline Halves<V> halves(V inverse_L, V x, V half_root) {
  const V large = sqrt(fma(V(0.5) * abs(x), inverse_L, V(0.5)));
  const V inverse_large = V(1) / large;
  const V small = half_root * inverse_L * inverse_large;
  const Mask<V> positive = x >= V(0);
  return {positive, select(positive, large, small), select(positive, small, large), large, inverse_large};
}

template <class V>
HATBOX_INLINE inline DiskCone<V>::DiskCone(const DiskLight<V>& disk, V x, V y, V z) : light(disk) {
  const DiskLocal<V> l = to_disk(light, x, y, z);
  height = abs(l.n);
  below = l.n > V(0);

  const Pair<V> uu = two_product(l.u, l.u), vv = two_product(l.v, l.v);
  const Pair<V> sum = two_sum(uu.high, vv.high);
  const Pair<V> rest = two_sum(sum.high, V(-1));
  d2_minus_1 = rest.high + (rest.low + (sum.low + (uu.low + vv.low)));
  const V d2 = sum.high;
  // Nearer to the axis one of the squares may have underflowed that still counts.
  const Mask<V> off_axis = d2 >= constant<V>(least_sum_of_products<V>);
  d = select(off_axis, sqrt(d2), V(0));
  const V inverse_d = V(1) / select(off_axis, d, V(1));
  t_u = select(off_axis, l.u * inverse_d, V(1));
  t_v = select(off_axis, l.v * inverse_d, V(0));

  const V h2 = height * height;
  const V s = d2_minus_1 + h2;
  const V L = length_with_root(s, V(2) * height);
  const V inverse_L = V(1) / L;
  const Halves<V> beta = halves(inverse_L, s, height);
  const Halves<V> m = halves(inverse_L, d2_minus_1 - h2, height * d);
  const V inverse_a2 = fma(V(0.5), s + L, V(1));  // what cancels next to the disk is small beside 1
  const V a2 = V(1) / inverse_a2;
  const V inverse_a = sqrt(inverse_a2);
  this->b = beta.minus;
  this->a = min(inverse_a * a2, V(1));
  this->inverse_ab = inverse_a / this->b;
  this->cos_beta = beta.plus;
  this->k2 = L * a2;
  kappa = a2 * d;
  m_t = m.plus;
  m_n = m.minus;
  height_over_m_n = select(m.positive, L * (m.large * inverse_d), height * m.inverse_large);
  this->valid = (height > V(0)) && (d2 + h2 < constant<V>(infinity<V>));
}

/// How near the light's plane a direction lies: n̂·q = m_n·value, distance = |h|/(m_n·value).
template <class V>
struct Descent {
  V value, inverse;
};

/// Of `conjugate`, or where that is the conjugate of what is wanted, of their product over it; all times `scale`.
template <class V>
HATBOX_INLINE inline Descent<V> descent_by_conjugate(Mask<V> away, V product, V conjugate, V scale) {
  const V numerator = select(away, product, conjugate);
  const V denominator = select(away, conjugate, scale);
  return {numerator / denominator, denominator / numerator};
}

// It is z − κ Y, with X = cos α x and Y = cos β y, which cancels where a ray grazes the far half of the disk. Times its
// conjugate z + κ Y it is, since z² = X² + Y² + (1 − x² − y²), a sum of positive terms:
//   k'² z² + κ² (1 − x² − y² + X²)
template <class V>
HATBOX_INLINE inline Descent<V> descent(const DiskCone<V>& cone, const EllipsePoint<V>& q) {
  const V tilt = cone.kappa * cone.cos_beta * q.y;
  const V conjugate = q.z + abs(tilt);
  const V XX = cone.k2 * (cone.cos_beta * cone.cos_beta) * q.xx;
  const V product = fma(cone.kappa * cone.kappa, XX + q.inwards, cone.k2 * q.zz);
  return descent_by_conjugate(tilt > V(0), product, conjugate, q.scale);
}

// On the disk the place of q is a Möbius map of the tangent ellipse's unit disk:
//   τ = (Y/z − κ)/(1 − κ Y/z),  σ = k' (X/z)/(1 − κ Y/z)
// along t̂ and n̂ × t̂. Where κ is near 1 the denominator is small and τ follows better from the distance.
template <class V>
HATBOX_INLINE inline void DiskCone<V>::emit(const EllipsePoint<V>& q, LightSample<V>& out) const {
  const Descent<V> down = descent(*this, q);
  const V q_x = this->a * q.x * q.inverse_scale;
  const V q_t = fma(m_t, q.z, m_n * (this->b * q.y)) * q.inverse_scale;
  const V q_n = m_n * down.value;
  const V along[3] = {fma(q_t, t_u, -(q_x * t_v)), fma(q_t, t_v, q_x * t_u), select(below, q_n, -q_n)};
  set_direction(light.axes, along, out);
  const V distance = height_over_m_n * down.inverse;
  out.distance = distance * V(light.radius);
  const V far_tau = fma(-kappa, q.z, this->cos_beta * q.y) * q.inverse_scale * down.inverse;
  const V near_tau = fma(distance, q_t, -d);
  const V tau = select(kappa < V(0.5), far_tau, near_tau);
  const V sigma = distance * q_x;
  out.place = {fma(tau, t_u, -(sigma * t_v)), fma(tau, t_v, sigma * t_u)};
}

template <class V>
inline EllipseHit<V> DiskCone<V>::hit(const V (&direction)[3]) const {
  const V q_u = along(light.axes[0], direction), q_v = along(light.axes[1], direction);
  const V normal = along(light.axes[2], direction);
  const V q_t = fma(q_u, t_u, q_v * t_v);
  const V q_n = select(below, normal, -normal);
  const V q_x = fma(q_v, t_u, -(q_u * t_v));
  const V q_y = fma(m_n, q_t, -(m_t * q_n));
  EllipseHit<V> hit;
  hit.x = q_x / this->a;
  hit.y = q_y / this->b;
  hit.z = fma(m_t, q_t, m_n * q_n);
  const V blur = constant<V>(8 * std::numeric_limits<Scalar<V>>::epsilon());
  const V x = max(abs(q_x) - blur, V(0)) / this->a;
  const V y = max(abs(q_y) - blur, V(0)) / this->b;
  hit.inside = this->valid && (fma(x, x, y * y) <= V(1)) && (hit.z > -blur) && (q_n > -blur);
  return hit;
}

/// `emit`'s Möbius map, inverted: tan η = (Y/cos β)/(X/cos α) = (τ + κ)/σ.
template <class V>
inline SinCos<V> DiskCone<V>::eta_of(const Place<V>& place) const {
  const V tau = fma(place.s, t_u, place.t * t_v);
  const V sigma = fma(place.t, t_u, -(place.s * t_v));
  return angle_of(sigma, tau + kappa).angle;
}

/// tan φ_p = tan β Y/(z cos β) with Y/z = (τ + κ)/(1 + κτ), so that tan χ = (τ + κ)/(cos α √(1 − τ²)).
template <class V>
inline SinCos<V> DiskCone<V>::chi_of(const Place<V>& place) const {
  const V tau = fma(place.s, t_u, place.t * t_v);
  const V half_chord = sqrt(max((V(1) - tau) * (V(1) + tau), V(0)));
  return angle_of(sqrt(this->k2) * this->cos_beta * half_chord, tau + kappa).angle;
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
