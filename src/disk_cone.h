// The cone of directions from a shading point to a disk: the spherical ellipse's semi-axes, centre and frame, without
// cancellation. Lengths are in radii of the disk.
//
// Source: Guillén et al. 2017, eq. 3-5, rearranged. With the heights and rim distances of the shading point
//   ℓ0 = √((d − 1)² + h²),  ℓ1 = √((d + 1)² + h²),  L = ℓ0 ℓ1,  s = d² + h² − 1,  X = d² − h² − 1
// the paper's quantities are
//   sin α = 2/(ℓ0 + ℓ1),  k' = cos α/cos β = 2√L/(ℓ0 + ℓ1),
//   2L sin² β = L − s,  2L cos² β = L + s,  (L − s)(L + s) = 4h²,
//   2L m_t² = L + X,    2L m_n² = L − X,    (L − X)(L + X) = 4d²h²
// where m_t and m_n are the components of the ellipse's centre direction along t̂ (in the disk's plane, from the foot of
// the shading point to the disk's centre) and along the axis. Of each pair the one that would cancel is formed from the
// other. κ = (ℓ1 − ℓ0)/(ℓ1 + ℓ0) = √(1 − k'²) is how far off the disk's centre the centre direction meets it.
#pragma once

#include "compensated.h"
#include "kernel_table.h"

namespace hatbox::HATBOX_ISA {
namespace {

template <class V>
using Constants = DiskConstantsOf<Scalar<V>>;

template <class V>
struct DiskCone {
  Mask<V> valid;  // false in the disk's plane and for non-finite points; the rest is then of no use
  Mask<V> below;  // the shading point lies on the side of −normal
  V height, d;    // |h| > 0 and d of the above
  V t_u, t_v;     // t̂ in the disk's own axes; any unit vector for a point on the axis
  V a, b;         // sin α, sin β
  V inverse_ab;   // of use where their product would underflow
  V b_over_a;     // of use where both would underflow when squared
  V cos_beta;
  V k2;        // k'²
  V kappa;     // κ
  V m_t, m_n;  // see above
  V height_over_m_n;
};

/// From a point of the world to the disk's centre, in the disk's axes and in radii.
template <class V>
struct DiskLocal {
  V u, v, n;
};

// A rounded difference, u or v is the exact one of a point or a light an ulp aside, which is all that is known of them.
// The height is not that forgiving: next to the disk's plane the products cancel, and are compensated.
template <class V>
HATBOX_INLINE inline DiskLocal<V> to_disk(const Constants<V>& light, V x, V y, V z) {
  const V l[3] = {V(light.center[0]) - x, V(light.center[1]) - y, V(light.center[2]) - z};
  const auto rounded = [&](const Scalar<V>(&axis)[3]) {
    return fma(l[0], V(axis[0]), fma(l[1], V(axis[1]), l[2] * V(axis[2])));
  };
  return {rounded(light.axes_hi[0]), rounded(light.axes_hi[1]), dot(l, light.axes_hi[2], light.axes_lo[2])};
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
HATBOX_INLINE inline DiskCone<V> disk_cone(const Constants<V>& light, V x, V y, V z) {
  const DiskLocal<V> l = to_disk(light, x, y, z);
  DiskCone<V> cone;
  cone.height = abs(l.n);
  cone.below = l.n > V(0);

  const Pair<V> uu = two_product(l.u, l.u), vv = two_product(l.v, l.v);
  const Pair<V> sum = two_sum(uu.high, vv.high);
  const Pair<V> rest = two_sum(sum.high, V(-1));
  const V d2_minus_1 = rest.high + (rest.low + (sum.low + (uu.low + vv.low)));
  const V d2 = sum.high;
  const Mask<V> off_axis = d2 >= constant<V>(smallest_normal<V>);
  cone.d = select(off_axis, sqrt(d2), V(0));
  const V far = cone.d + V(1);
  const V nonzero_d = select(off_axis, cone.d, V(1));
  const V shared = V(1) / (nonzero_d * far);  // one division for 1/d and 1/(d + 1)
  const V inverse_d = far * shared;
  cone.t_u = select(off_axis, l.u * inverse_d, V(1));
  cone.t_v = select(off_axis, l.v * inverse_d, V(0));

  const V h2 = cone.height * cone.height;
  const V near = d2_minus_1 * (nonzero_d * shared);
  // The max keeps ℓ0 from underflowing to 0 right above or beside the rim.
  const V rim0 = max(sqrt(fma(near, near, h2)), max(cone.height, abs(near)));
  const V rim1 = sqrt(fma(far, far, h2));
  const V L = rim0 * rim1;
  const V inverse_L = V(1) / L;
  const Halves<V> beta = halves(inverse_L, d2_minus_1 + h2, cone.height);
  const Halves<V> m = halves(inverse_L, d2_minus_1 - h2, cone.height * cone.d);
  const V inverse_a = V(0.5) * (rim0 + rim1);
  cone.b = beta.minus;
  cone.b_over_a = beta.minus * inverse_a;
  const V a_over_b = V(1) / cone.b_over_a;
  cone.a = min(cone.b * a_over_b, V(1));
  cone.inverse_ab = inverse_a * inverse_a * a_over_b;
  cone.cos_beta = beta.plus;
  cone.k2 = L * cone.a * cone.a;
  cone.kappa = cone.a * cone.a * cone.d;
  cone.m_t = m.plus;
  cone.m_n = m.minus;
  cone.height_over_m_n = select(m.positive, L * (m.large * inverse_d), cone.height * m.inverse_large);
  cone.valid = (cone.height > V(0)) && (d2 + h2 < constant<V>(infinity<V>));
  return cone;
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
