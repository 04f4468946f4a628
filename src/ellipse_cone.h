// The cone of directions from a shading point to an elliptical disk: the spherical ellipse's semi-axes, centre and
// frame, without cancellation, and the way between its points and the light's.
//
// With the confocal ellipsoid λ of confocal.h, Δ = diag(1 + λ, r² + λ, λ) and l from the point to the centre,
//   w = Δ^{−1/2} l  is of unit length,  X, Y, Z its squared components,  ẑ_e = Δ^{−1/2} w/N.
// The light's dual cone is diag(1, r², 0) − l lᵀ = Δ^{1/2}(1 − w wᵀ)Δ^{1/2} − λ, so the other axes of the cone are
//   x̂_e = Δ^{1/2} y₃/σ₃,  ŷ_e = Δ^{1/2} y₂/σ₂,  σᵢ² = κᵢ + λ
// where y₃ and y₂ are the eigenvectors, in the plane w^⊥, of diag(1, r², 0) cut down to it, with the eigenvalues
// κ₃ >= κ₂: the squared semi-axes of the section at right angles to ẑ_e, at the distance √λ. Their first two components
// come from the symmetric matrix of order two
//   M = (Y + Z, −r √(XY); −r √(XY), r² (X + Z)),  det M = r² Z,
// of which (c, s) and (s, −c) are the eigenvectors: y₃ = √κ₃ (c, s/r, …) and y₂ = √κ₂ (s, −c/r, …). So
//   sin α = √(κ₃)/σ₃,  cos α = √λ/σ₃,  sin β = √(κ₂)/σ₂,  cos β = √λ/σ₂.
// All sums here are of positive terms, but for the difference of M's diagonal, which cancels where the cone is circular
// and any axes will do. For r = 1 all of this is disk_cone.h, and x̂_e and ŷ_e are the disk's.
//
// Rejected: Jacobi's method with rotations and hyperbolic rotations of (semi-axes, l) (Veselić 1993). As accurate, but
// it takes three sweeps of three rotations, each with more divisions and roots than a step of confocal.h.
#pragma once

#include "confocal.h"

namespace hatbox::HATBOX_ISA {
namespace {

/// From the caller's axes to the longer and the shorter one, or back.
template <class V>
inline Place<V> sorted_place(const EllipseLight<V>& light, const Place<V>& place) {
  const Mask<V> swapped = V(light.swapped) > V(0);
  return {select(swapped, place.t, place.s), select(swapped, place.s, place.t)};
}

/// Of an ellipse: |h| > 0, x̂_e to the left of l, ŷ_e along it. In the light's own axes, of which the normal is towards
/// the light.
template <class V>
struct EllipseCone : SphericalEllipse<V> {
  using Light = EllipseLight<V>;

  HATBOX_INLINE EllipseCone(const EllipseLight<V>& ellipse, V x, V y, V z);

  /// Direction, distance, cosine and place of a point of the ellipse.
  HATBOX_INLINE void emit(const EllipsePoint<V>& q, LightSample<V>& out) const;

  /// Where a direction of unit length lies. A sampled one is right to a few ulp: what these could move inside, is.
  EllipseHit<V> hit(const V (&direction)[3]) const;

  /// The angle η of the direction to a place on the light.
  SinCos<V> eta_of(const Place<V>& place) const;

  Place<V> sorted(const Place<V>& place) const { return sorted_place(light, place); }

  const EllipseLight<V>& light;
  Mask<V> below;           // the shading point lies on the side of −normal
  V x_axis[2], y_axis[2];  // a x̂_e and b ŷ_e along the longer and the shorter axis …
  V z_axis[2], m_n;        // … ẑ_e, and ẑ_e along the normal
  V w_u, r_w_v;            // of w above
  V stretch[2];            // √(1 + λ), √(r² + λ)
  V c, s;                  // the eigenvectors of M
  V kappa2, nearness;      // κ² and 1 − κ²
  V tilt[2], cross[2];     // κ · (X, Y) and κ × (X, Y) of a point (x, y): see `descent`
  V reach;                 // distance · value of `descent`
  V place_row[2][3];       // place = (row · q)/value − origin
  V origin[2];

 private:
  struct Section;
  HATBOX_INLINE void set_semi_axes(const Section& section, V w_n);
  HATBOX_INLINE void set_axes(const Section& section);
  HATBOX_INLINE void set_places(const Section& section, const EllipseLocal<V>& l);
};

template <class V>
HATBOX_INLINE inline EllipseLocal<V> ellipse_local(const EllipseLight<V>& light, const DiskLocal<V>& l) {
  const Pair<V> uu = two_product(l.u, l.u), vv = two_product(l.v, l.v);
  const Pair<V> sum = two_sum(uu.high, vv.high);
  const Pair<V> rest = two_sum(sum.high, V(-1));
  return {.u = l.u,
          .v = l.v * V(light.ratio),
          .height = abs(l.n),
          .v_over_r = l.v,
          .offset = rest.high + (rest.low + (sum.low + (uu.low + vv.low))),
          .u_offset = (uu.high - V(1)) + uu.low};
}

/// The eigenvectors (c, s), (s, −c) and the larger eigenvalue of M.
template <class V>
struct Eigen {
  V c, s;
  V largest;
};

// Half the angle of (M₁₁ − M₂₂, 2 M₁₂): its larger part directly, the other from their product. The signs are those
// that turn x̂_e to the left of l, which needs no case since M₁₂ has the sign of −w_u w_v.
template <class V>
HATBOX_INLINE inline Eigen<V> eigen(const EllipseLight<V>& light, V w_u, V w_v, V w_n) {
  const V X = w_u * w_u, Y = w_v * w_v, Z = w_n * w_n;
  const V ratio2 = V(light.ratio2);
  const V difference = fma(V(light.flattening), Z, fma(-ratio2, X, Y));
  const V product = V(light.ratio) * (w_u * w_v);
  // Nearer to the axis what of these may have underflowed counts, and squares of them did long before.
  const V length = length_of_small(difference, V(2) * product);
  const Mask<V> circular = !(length >= constant<V>(least_sum_of_products<V>));
  const V size = select(circular, V(1), length);
  const V inverse_size = V(1) / size;
  const V large = select(circular, V(1), sqrt(fma(V(0.5) * abs(difference), inverse_size, V(0.5))));
  const V small = select(circular, V(0), abs(product) * inverse_size / large);
  const Mask<V> along_u = (difference > V(0)) && !circular;
  return {copysign(select(along_u, large, small), V(0) - w_v), copysign(select(along_u, small, large), w_u + V(0)),
          V(0.5) * (fma(ratio2, X + Z, Y + Z) + select(circular, V(0), size))};
}

/// The section at right angles to ẑ_e, and where ẑ_e meets the light.
template <class V>
struct EllipseCone<V>::Section {
  V lambda, distance;             // of its centre, squared and not
  V A, B;                         // √κ₃ and √κ₂, its semi-axes
  V sigma3, sigma2;               // √(κ₃ + λ), √(κ₂ + λ)
  V inverse_both;                 // 1/(σ₃σ₂)
  V p_u, p_v;                     // κ = (p_u, r p_v)
  V root_nearness, inverse_root;  // √(1 − κ²) and its inverse

  V inverse3() const { return sigma2 * inverse_both; }
  V inverse2() const { return sigma3 * inverse_both; }
};

template <class V>
HATBOX_INLINE inline EllipseCone<V>::EllipseCone(const EllipseLight<V>& ellipse, V x, V y, V z) : light(ellipse) {
  const DiskLocal<V> to_center = to_disk(light, x, y, z);
  const EllipseLocal<V> l = ellipse_local(light, to_center);
  below = to_center.n > V(0);
  const Confocal<V> confocal = ConfocalEllipsoid<V>(light, l).solve();
  const V r = V(light.ratio);

  stretch[0] = sqrt(V(1) + confocal.lambda);
  stretch[1] = sqrt(V(light.ratio2) + confocal.lambda);
  const V shrink[2] = {V(1) / stretch[0], V(1) / stretch[1]};
  w_u = l.u * shrink[0];
  const V w_v = l.v * shrink[1], w_n = l.height / confocal.root;
  r_w_v = r * w_v;
  const Eigen<V> M = eigen(light, w_u, w_v, w_n);
  c = M.c;
  s = M.s;

  Section section;
  section.lambda = confocal.lambda;
  section.distance = confocal.root;
  section.A = sqrt(M.largest);
  section.B = r * w_n / section.A;
  section.sigma3 = sqrt(M.largest + confocal.lambda);
  section.sigma2 = sqrt(fma(section.B, section.B, confocal.lambda));
  section.inverse_both = V(1) / (section.sigma3 * section.sigma2);
  section.p_u = w_u * shrink[0];
  section.p_v = w_v * shrink[1];
  kappa2 = fma(section.p_u, section.p_u, (r * section.p_v) * (r * section.p_v));
  // λ p² as the square of √λ p: that of p alone may underflow.
  const V u_near = section.distance * section.p_u, v_near = section.distance * section.p_v;
  nearness = fma(u_near, u_near, fma(v_near, v_near, w_n * w_n));
  section.root_nearness = sqrt(nearness);
  section.inverse_root = V(1) / section.root_nearness;
  m_n = w_n * section.inverse_root;

  set_semi_axes(section, w_n);
  set_axes(section);
  set_places(section, l);
  // Of a lower height products with the ratio of the axes are no normal floats. From farther away 1/λ is none, and λ,
  // which takes steps by its inverse, no longer tells.
  const V distance2 = fma(l.height, l.height, fma(l.u, l.u, l.v * l.v));
  this->valid = (l.height >= constant<V>(0x1p20 * smallest_normal<V>)) && is_finite(l.offset) &&
                (distance2 < constant<V>(0.25 / smallest_normal<V>));
}

template <class V>
HATBOX_INLINE inline void EllipseCone<V>::set_semi_axes(const Section& section, V w_n) {
  const V k_prime = section.sigma2 * section.inverse3();
  this->a = min(section.A * section.inverse3(), V(1));
  this->b = min(section.B * section.inverse2(), V(1));
  this->inverse_ab = section.sigma3 * (section.sigma2 / (V(light.ratio) * w_n));
  this->cos_beta = section.distance * section.inverse2();
  this->k2 = k_prime * k_prime;
}

// a or b times what is of the order of one, so that nothing underflows for far lights.
template <class V>
HATBOX_INLINE inline void EllipseCone<V>::set_axes(const Section& section) {
  const V inverse_r = V(light.inverse_ratio);
  x_axis[0] = this->a * (this->a * stretch[0] * c);
  x_axis[1] = this->a * (this->a * stretch[1] * s * inverse_r);
  y_axis[0] = this->b * (this->b * stretch[0] * s);
  y_axis[1] = -(this->b * (this->b * stretch[1] * c * inverse_r));
  z_axis[0] = section.p_u * section.distance * section.inverse_root;
  z_axis[1] = section.p_v * section.distance * section.inverse_root;
}

// A place is a projective map of q. Where κ is near 1 its denominator is small, and the place follows better from the
// distance, less the centre's place, which is small there. Either way it is linear in q; the coefficients differ by
// factors.
template <class V>
HATBOX_INLINE inline void EllipseCone<V>::set_places(const Section& section, const EllipseLocal<V>& l) {
  reach = section.distance * section.root_nearness;
  const V across_x = reach * section.inverse3() * section.inverse3();
  const V across_y = reach * section.inverse2() * section.inverse2();
  const V kappa_x = fma(w_u, c, r_w_v * s), kappa_y = fma(w_u, s, -(r_w_v * c));
  tilt[0] = across_x * kappa_x;
  tilt[1] = across_y * kappa_y;
  cross[0] = reach * section.inverse_both * kappa_x;
  cross[1] = reach * section.inverse_both * kappa_y;

  const Mask<V> near = nearness < V(0.25);
  const V r = V(light.ratio), inverse_r = V(light.inverse_ratio);
  const V x = across_x * select(near, section.A * section.A, V(1));
  const V y = across_y * select(near, section.B * section.B, V(1));
  const V z = select(near, section.lambda, V(-1));
  const V by_r = select(near, inverse_r, V(1));
  place_row[0][0] = x * stretch[0] * c;
  place_row[0][1] = y * stretch[0] * s;
  place_row[0][2] = z * section.p_u;
  place_row[1][0] = x * by_r * by_r * stretch[1] * s;
  place_row[1][1] = -(y * by_r * by_r * stretch[1] * c);
  place_row[1][2] = z * select(near, inverse_r, r) * section.p_v;
  origin[0] = select(near, l.u, V(0));
  origin[1] = select(near, l.v_over_r, V(0));
}

// n̂·q = m_n·value with value = z − κ·(X, Y), X = cos α x, Y = cos β y, which cancels where a ray grazes the far part of
// the light. Times its conjugate z + κ·(X, Y) it is, since z² = X² + Y² + (1 − x² − y²), a sum of positive terms:
//   (1 − κ²) z² + κ² (1 − x² − y²) + (κ × (X, Y))²
template <class V>
HATBOX_INLINE inline Descent<V> descent(const EllipseCone<V>& cone, const EllipsePoint<V>& q) {
  const V tilt = fma(cone.tilt[0], q.x, cone.tilt[1] * q.y);
  const V cross = fma(cone.cross[0], q.y, -(cone.cross[1] * q.x));
  const V conjugate = q.z + abs(tilt);
  const V product = fma(cone.kappa2, q.inwards, fma(cone.nearness, q.zz, cross * cross * q.inverse_scale));
  return descent_by_conjugate(tilt > V(0), product, conjugate, q.scale);
}

template <class V>
HATBOX_INLINE inline void EllipseCone<V>::emit(const EllipsePoint<V>& q, LightSample<V>& out) const {
  const Descent<V> down = descent(*this, q);
  const V q_n = m_n * down.value;
  const V along[3] = {fma(x_axis[0], q.x, fma(y_axis[0], q.y, z_axis[0] * q.z)) * q.inverse_scale,
                      fma(x_axis[1], q.x, fma(y_axis[1], q.y, z_axis[1] * q.z)) * q.inverse_scale,
                      select(below, q_n, -q_n)};
  set_direction(light.axes, along, out);
  out.distance = reach * down.inverse * V(light.radius);
  const auto place = [&](int i) HATBOX_INLINE {
    const V numerator = fma(place_row[i][0], q.x, fma(place_row[i][1], q.y, place_row[i][2] * q.z));
    return fma(numerator, q.inverse_scale * down.inverse, -origin[i]);
  };
  // Next to a narrow light's tip rounding can lead off it.
  const V place_s = place(0), place_t = place(1), r2 = fma(place_s, place_s, place_t * place_t);
  const V inwards = select(r2 > V(1), V(1) / sqrt(r2), V(1));
  out.place = sorted({place_s * inwards, place_t * inwards});
}

template <class V>
inline EllipseHit<V> EllipseCone<V>::hit(const V (&direction)[3]) const {
  const V q_u = along(light.axes[0], direction), q_v = along(light.axes[1], direction);
  const V normal = along(light.axes[2], direction);
  const V q_n = select(below, normal, -normal);
  const V m_q_n = m_n * q_n;
  const V inverse_a = V(1) / this->a, inverse_b = V(1) / this->b;
  const V q_x = fma(x_axis[0], q_u, fma(x_axis[1], q_v, -(tilt[0] * m_q_n))) * inverse_a;
  const V q_y = fma(y_axis[0], q_u, fma(y_axis[1], q_v, -(tilt[1] * m_q_n))) * inverse_b;
  EllipseHit<V> hit;
  hit.x = q_x * inverse_a;
  hit.y = q_y * inverse_b;
  hit.z = fma(z_axis[0], q_u, fma(z_axis[1], q_v, m_q_n));
  const V blur = constant<V>(8 * std::numeric_limits<Scalar<V>>::epsilon());
  const V x = max(abs(q_x) - blur, V(0)) * inverse_a;
  const V y = max(abs(q_y) - blur, V(0)) * inverse_b;
  hit.inside = this->valid && (fma(x, x, y * y) <= V(1)) && (hit.z > -blur) && (q_n > -blur);
  return hit;
}

/// `emit`'s projective map, inverted: w ∝ Δ^{1/2} of a place seen from the light's centre of perspective.
template <class V>
inline SinCos<V> EllipseCone<V>::eta_of(const Place<V>& given) const {
  const Place<V> place = sorted(given);
  const V u = fma(stretch[0], place.s, w_u), v = fma(stretch[1], place.t, r_w_v);
  return angle_of(fma(c, u, s * v), fma(s, u, -(c * v))).angle;
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
