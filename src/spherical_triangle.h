// The spherical triangle that a triangle in a plane is seen as: its solid angle, its points by solid angle, and back.
// Forward nothing cancels that matters: right to 1e-6 from the smallest float to 2π, hugging an edge or seen from afar.
//
// Source: Arvo 1995, "Stratified Sampling of Spherical Triangles", in half angles. A, B, C are the vertices counted
// from the apex, the one opposite the smallest side; a, b, c the sides opposite to them and α, β, γ their angles. With
//   s_x = sin(x/2), c_x = cos(x/2) of a side,   K = c_b c_c,   L = s_b s_c
// the area follows from two sides and their angle (Todhunter 1886, §103):
//   c_a cos(Ω/2) = K + L cos α,   c_a sin(Ω/2) = L sin α
// and since a <= 2π/3, the sum K + L cos α has lost nothing where both are small. u cuts off a part A B C_u of area uΩ,
// C_u on side b, v a point of the arc from B to C_u. Let θ = uΩ/2, θ̄ = (1 − u)Ω/2, Q = sin(α − θ), b_u the arc A C_u:
//   c_a Q = K sin α cos θ̄ + (K cos α + L) sin θ̄                     (or the plain difference, where that is a sum)
//   H sin(b_u/2) = c_c sin θ,   H cos(b_u/2) = s_c Q,   H sin((b − b_u)/2) = c_a sin θ̄,   H² = c_c² sin² θ + s_c² Q²
//   H cos(a_u/2) = sin α s_c c_c,   a_u the arc B C_u
#pragma once

#include "triangle_local.h"
#include "trig.h"
#include "unit_square.h"

namespace hatbox::HATBOX_ISA {
namespace {

/// A point of the triangle, by its direction and by its place in the plane.
template <class V>
struct TrianglePoint {
  V direction[3];  // of unit length, in the plane's axes
  V distance;
  Place<V> place;  // vertex 0 + s (vertex 1 − vertex 0) + t (vertex 2 − vertex 0)
};

/// Sine and cosine of half an angle in [0, π], given its own: whichever half would cancel is formed from the other.
template <class V>
HATBOX_INLINE inline SinCos<V> half_angle(V sin, V cos) {
  const Mask<V> acute = cos >= V(0);
  const V large = V(1) + abs(cos);
  const V scale = V(1) / sqrt(fma(sin, sin, large * large));
  return {select(acute, sin, large) * scale, select(acute, large, sin) * scale};
}

/// The angle in [0, π] of a vector in the upper half plane, right to a few ulp of itself.
template <class V>
HATBOX_INLINE inline V angle_of_upper(V y, V x) {
  const V size = abs(x);
  const Mask<V> flat = y <= size;
  const V t = atan_unit(min(y, size) / max(y, size));
  const V from_axis = select(flat, t, constant<V>(pi / 2) - t);
  return select(x < V(0), constant<V>(pi) - from_axis, from_axis);
}

template <class V>
class SphericalTriangle {
 public:
  HATBOX_INLINE explicit SphericalTriangle(const PlaneTriangle<V>& plane);

  V solid_angle() const { return half_area_ + half_area_; }
  V inverse_solid_angle() const { return inverse_area_; }

  HATBOX_INLINE TrianglePoint<V> sample(V u, V v) const { return sample(shares_of(u), v); }

  /// Right also where u is next to 0 or 1, as far as its smaller share is.
  HATBOX_INLINE TrianglePoint<V> sample(const Shares<V>& u, V v) const;

  /// The (u, v) of a direction inside; of others nearby some point of the square.
  Square<V> invert(const V (&direction)[3]) const;

  /// Whether a direction lies inside, within a margin of 16 ulp of its coordinates.
  Mask<V> contains(const V (&direction)[3]) const;

  /// Where the plane is met, for a direction inside.
  Place<V> place_of(const V (&direction)[3]) const;

  /// On which side of the plane of side i: positive within.
  V inwards(int i, const V (&direction)[3]) const { return dot3(direction, normal_x_[i], normal_y_[i], normal_z_[i]); }

  /// This triangle where the mask is set, the other one elsewhere. What is not used of it costs nothing. To be had from
  /// either_triangle.h.
  HATBOX_INLINE SphericalTriangle either(const Mask<V>& mask, const SphericalTriangle& other) const;

 private:
  template <class T>
  T turned(const T (&of_vertex)[3], int i) const {  // of vertex A, B or C
    return select(first_, of_vertex[i], select(second_, of_vertex[(i + 1) % 3], of_vertex[(i + 2) % 3]));
  }
  SinCos<V> turned(const SinCos<V> (&of_side)[3], int i) const {
    const V sin[3] = {of_side[0].sin, of_side[1].sin, of_side[2].sin};
    const V cos[3] = {of_side[0].cos, of_side[1].cos, of_side[2].cos};
    return {turned(sin, i), turned(cos, i)};
  }
  static V dot3(const V (&p)[3], V x, V y, V z) { return fma(p[0], x, fma(p[1], y, p[2] * z)); }

  V z_;
  V unit_x_[3], unit_y_[3], unit_z_[3];        // the vertices' directions
  V normal_x_[3], normal_y_[3], normal_z_[3];  // of the planes of the sides, inwards
  V span_[3];                                  // the lengths of the sides' cross products
  SinCos<V> half_side_[3];
  Mask<V> first_, second_;  // which vertex is A; neither: the third
  // From here on for the vertices A, B, C.
  SinCos<V> b_, c_;  // of half the side
  V inverse_cos_a_;  // of half of a
  V cos_a_;
  SinCos<V> alpha_;
  SinCos<V> half_;  // of Ω/2
  V half_area_, inverse_area_;
  V B_[3], n_[3], t_[3];              // B, the normal of the plane of A and B, and B × n, towards A
  V weight_A_, weight_B_, weight_C_;  // 1/|A| and alike, those of A and C over s_b c_b
};

template <class V>
HATBOX_INLINE inline SphericalTriangle<V>::SphericalTriangle(const PlaneTriangle<V>& plane) : z_(plane.z) {
  V length[3], inverse[3], inverse_span[3];
  for (int i = 0; i < 3; ++i) {
    length[i] = length_of_small(plane.x[i], plane.y[i], z_);
    inverse[i] = V(1) / length[i];
    unit_x_[i] = plane.x[i] * inverse[i];
    unit_y_[i] = plane.y[i] * inverse[i];
    unit_z_[i] = z_ * inverse[i];
    span_[i] = length_of_small(plane.cross[i], z_ * plane.length[i]);
    inverse_span[i] = V(1) / span_[i];
    const V lean = z_ * inverse_span[i];
    normal_x_[i] = -(plane.side_y[i] * lean);
    normal_y_[i] = plane.side_x[i] * lean;
    normal_z_[i] = plane.cross[i] * inverse_span[i];
  }
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const V cos = fma(unit_x_[j], unit_x_[k], fma(unit_y_[j], unit_y_[k], unit_z_[j] * unit_z_[k]));
    half_side_[i] = half_angle(span_[i] * (inverse[j] * inverse[k]), cos);
  }
  const V s0 = half_side_[0].sin, s1 = half_side_[1].sin, s2 = half_side_[2].sin;
  first_ = (s0 <= s1) && (s0 <= s2);
  second_ = s1 <= s2;
  cos_a_ = turned(half_side_, 0).cos;
  inverse_cos_a_ = V(1) / cos_a_;
  b_ = turned(half_side_, 1);
  c_ = turned(half_side_, 2);

  // The angle between the planes of b and c.
  const V n_b[3] = {turned(normal_x_, 1), turned(normal_y_, 1), turned(normal_z_, 1)};
  n_[0] = turned(normal_x_, 2);
  n_[1] = turned(normal_y_, 2);
  n_[2] = turned(normal_z_, 2);
  alpha_.cos = -dot3(n_, n_b[0], n_b[1], n_b[2]);
  alpha_.sin = plane.doubled_area * ((z_ * turned(inverse_span, 1)) * (turned(length, 0) * turned(inverse_span, 2)));

  const V L = b_.sin * c_.sin;
  const V y = L * alpha_.sin, x = fma(L, alpha_.cos, b_.cos * c_.cos);
  half_area_ = angle_of_upper(y, x);
  inverse_area_ = V(0.5) / half_area_;
  half_ = {y * inverse_cos_a_, x * inverse_cos_a_};

  B_[0] = turned(unit_x_, 1);
  B_[1] = turned(unit_y_, 1);
  B_[2] = turned(unit_z_, 1);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    t_[i] = fma(B_[j], n_[k], -(B_[k] * n_[j]));
  }
  const V inverse_sin_b = V(1) / (b_.sin * b_.cos);
  weight_A_ = turned(inverse, 0) * inverse_sin_b;
  weight_B_ = turned(inverse, 1);
  weight_C_ = turned(inverse, 2) * inverse_sin_b;
}

// With q the arc from B to the point, sin²(q/2) = v sin²(a_u/2). In the frame of B, n = A × B/|A × B| and B × n, the
// arc to C_u starts at the angle β to the one towards A:
//   sin(a_u/2) cos β = (s_c² Q cos θ − c_c² sin θ cos(α − θ))/H,   sin(a_u/2) sin β = Q sin θ/H
// The place is the mean of the vertices by the weights of B sin(a_u − q) + C_u sin q, C_u ~ A sin(b − b_u) + C sin b_u,
// all of them positive; their sum of vertices has the length cos(a_u/2), with the common factor 2 sin(a_u/2) left out.
template <class V>
HATBOX_INLINE inline TrianglePoint<V> SphericalTriangle<V>::sample(const Shares<V>& u, V v) const {
  v = clamp_variate(v);
  const V rest_v = V(1) - v;
  const SinCos<V> near = doubled(sincos_octant(min(u.share, u.rest) * half_area_ * constant<V>(2 / pi)));
  const SinCos<V> far = {fma(half_.sin, near.cos, -(half_.cos * near.sin)),
                         fma(half_.cos, near.cos, half_.sin * near.sin)};
  const Mask<V> first_half = u.share <= u.rest;
  const SinCos<V> theta = {select(first_half, near.sin, far.sin), select(first_half, near.cos, far.cos)};
  const SinCos<V> rest = {select(first_half, far.sin, near.sin), select(first_half, far.cos, near.cos)};

  const V K = b_.cos * c_.cos, L = b_.sin * c_.sin;
  const V difference = fma(alpha_.sin, theta.cos, -(alpha_.cos * theta.sin));
  const V sum = fma(K * alpha_.sin, rest.cos, fma(K, alpha_.cos, L) * rest.sin) * inverse_cos_a_;
  const V Q = select((alpha_.cos < V(0)) && (theta.cos >= V(0)), difference, sum);
  const V b_u_y = c_.cos * theta.sin, b_u_x = c_.sin * Q;
  const V inverse_H = V(1) / length_of_small(b_u_y, b_u_x);
  const SinCos<V> b_u = {b_u_y * inverse_H, b_u_x * inverse_H};
  const SinCos<V> rest_b = {cos_a_ * rest.sin * inverse_H, fma(b_.cos, b_u.cos, b_.sin * b_u.sin)};

  const V cos_beta =
      fma(c_.sin * b_u.cos, theta.cos, -(c_.cos * b_u.sin) * fma(alpha_.cos, theta.cos, alpha_.sin * theta.sin));
  const V sin_beta = theta.sin * (Q * inverse_H);
  const V cos_a_u = min(alpha_.sin * c_.cos * (c_.sin * inverse_H), V(1));
  const V sin2_a_u = fma(cos_beta, cos_beta, sin_beta * sin_beta);
  const V root_v = sqrt(v);
  const V cos_q = sqrt(fma(v * cos_a_u, cos_a_u, rest_v));
  const V side = root_v * cos_q;

  const V along_B = fma(V(-2) * v, sin2_a_u, V(1)), along_t = V(2) * side * cos_beta, along_n = V(2) * side * sin_beta;
  const V w_B = weight_B_ * (rest_v * fma(cos_a_u, cos_q, root_v * sin2_a_u) / fma(root_v, cos_a_u, cos_q));
  const V w_A = weight_A_ * (side * (rest_b.sin * rest_b.cos));
  const V w_C = weight_C_ * (side * (b_u.sin * b_u.cos));
  const V sum_of_weights = w_A + w_B + w_C;
  const V inverse_sum = V(1) / sum_of_weights;

  TrianglePoint<V> point;
  point.distance = cos_a_u * inverse_sum;
  const V direction[3] = {fma(along_B, B_[0], fma(along_t, t_[0], along_n * n_[0])),
                          fma(along_B, B_[1], fma(along_t, t_[1], along_n * n_[1])), z_ / point.distance};
  const V length2 = fma(direction[0], direction[0], fma(direction[1], direction[1], direction[2] * direction[2]));
  // Right at a vertex heights and cross products are rounding noise that contradicts itself: no sample is better.
  point.distance = select(abs(length2 - V(1)) <= constant<V>(0x1p-10), point.distance, constant<V>(infinity<V>));
  const V to_unit = fma(V(-0.5), length2, V(1.5));  // 1/√length², which is 1 but for rounding
  for (int i = 0; i < 3; ++i) point.direction[i] = direction[i] * to_unit;
  point.place = {select(first_, w_B, select(second_, w_A, w_C)) * inverse_sum,
                 select(first_, w_C, select(second_, w_B, w_A)) * inverse_sum};
  return point;
}

// The area of A B C_u follows from the angles α, β and the side c between them:
//   tan θ = 2 s_c² sin α sin β/(sin(α + β) + sin γ) = (sin γ − sin(α + β))/(2 (c_c² sin α sin β − cos α cos β))
//   sin² γ = (sin α cos β + cos c cos α sin β)² + (sin c sin β)²,  γ the angle of A B C_u at C_u
// and the arc a_u from  sin a_u = sin c sin α/sin γ,  cos a_u = (cos c cos β sin α + sin β cos α)/sin γ.
template <class V>
inline Square<V> SphericalTriangle<V>::invert(const V (&direction)[3]) const {
  const V cos_q = dot3(direction, B_[0], B_[1], B_[2]);
  const V y = max(dot3(direction, n_[0], n_[1], n_[2]), V(0));
  const V x = dot3(direction, t_[0], t_[1], t_[2]);
  const V sin_q = length_of_small(y, x);
  const Mask<V> at_B = !(sin_q > V(0));
  const V inverse = V(1) / select(at_B, V(1), sin_q);
  const SinCos<V> beta = {y * inverse, select(at_B, V(1), x * inverse)};

  const V sin_c = V(2) * c_.sin * c_.cos, cos_c = fma(V(-2) * c_.sin, c_.sin, V(1));
  const V ss = alpha_.sin * beta.sin, sc = alpha_.sin * beta.cos, cs = alpha_.cos * beta.sin;
  const V sin_sum = sc + cs;
  const V sin_gamma = length_of_small(fma(cos_c, cs, sc), sin_c * beta.sin);
  const Mask<V> below_pi = sin_sum >= V(0);
  const V theta_y = select(below_pi, V(2) * c_.sin * c_.sin * ss, sin_gamma - sin_sum);
  const V theta_x = select(below_pi, sin_sum + sin_gamma, V(2) * fma(c_.cos * c_.cos, ss, -(alpha_.cos * beta.cos)));
  const V u = angle_of_upper(theta_y, theta_x) / half_area_;

  const V cos_a_u = fma(cos_c, sc, cs);  // times sin γ, as what follows
  const V sin_a_u = sin_c * alpha_.sin;
  const V larger = sin_gamma + abs(cos_a_u);
  const V versine_a_u = select(cos_a_u >= V(0), sin_a_u * (sin_a_u / larger), larger);
  const V versine_q = select(cos_q >= V(0), sin_q * (sin_q / (V(1) + abs(cos_q))), V(1) - cos_q);
  const V v = versine_q * sin_gamma / versine_a_u;
  return {clamp_variate(u), clamp_variate(v)};
}

// Inside it is, by the sine of its angle, of the planes of all sides.
template <class V>
inline Mask<V> SphericalTriangle<V>::contains(const V (&direction)[3]) const {
  const V blur = constant<V>(16 * std::numeric_limits<Scalar<V>>::epsilon());
  Mask<V> inside = direction[2] >= -blur;
  for (int i = 0; i < 3; ++i) {
    inside = inside && (dot3(direction, normal_x_[i], normal_y_[i], normal_z_[i]) >= -blur);
  }
  // Seen edge-on the planes of all sides are nearly one: there the two vertices that bound the outline as seen from the
  // foot do it. Sides whose plane leans over are on its far side.
  V toward_x = V(0), toward_y = V(0);
  for (int i = 0; i < 3; ++i) {
    const Mask<V> starts = normal_z_[(i + 2) % 3] < V(0), ends = normal_z_[(i + 1) % 3] < V(0);
    const V reach = sqrt(fma(unit_x_[i], unit_x_[i], unit_y_[i] * unit_y_[i]));
    const V turn = fma(unit_x_[i], direction[1], -(unit_y_[i] * direction[0]));
    inside = inside && !(starts && !ends && (turn > blur * reach)) && !(ends && !starts && (turn < -blur * reach));
    const Mask<V> silhouette = (starts && !ends) || (ends && !starts);
    toward_x = toward_x + select(silhouette, unit_x_[i] / reach, V(0));
    toward_y = toward_y + select(silhouette, unit_y_[i] / reach, V(0));
  }
  inside = inside && !(fma(toward_x, direction[0], toward_y * direction[1]) < V(-2) * blur);
  return inside;
}

template <class V>
inline Place<V> SphericalTriangle<V>::place_of(const V (&direction)[3]) const {
  V w[3];
  for (int i = 0; i < 3; ++i) {
    w[i] = max(dot3(direction, normal_x_[i], normal_y_[i], normal_z_[i]), V(0)) * span_[i];
  }
  const V sum = w[0] + w[1] + w[2];
  const Mask<V> lost = !(sum > V(0));  // inside by the margin alone
  return {select(lost, constant<V>(1.0 / 3), w[1] / sum), select(lost, constant<V>(1.0 / 3), w[2] / sum)};
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
