// Whether a direction hits the disk, for all maps alike: it lies in the spherical ellipse.
#pragma once

#include "disk_cone.h"

namespace hatbox::HATBOX_ISA {
namespace {

/// A direction in the disk's axes, and in the frame x̂_e = n̂ × t̂, ŷ_e, ẑ_e of its spherical ellipse.
template <class V>
struct EllipseHit {
  V along[3];  // the disk's axis_u, axis_v, normal
  V x, y, z;   // x/sin α, y/sin β and z
  Mask<V> inside;
};

/// A sampled direction is right to a few ulp: what these could move inside counts as a hit.
template <class V>
inline EllipseHit<V> ellipse_hit(const Constants<V>& light, const DiskCone<V>& cone, const V (&direction)[3]) {
  EllipseHit<V> hit;
  for (int i = 0; i < 3; ++i) {
    const Scalar<V>(&axis)[3] = light.axes[i];
    hit.along[i] = fma(direction[0], V(axis[0]), fma(direction[1], V(axis[1]), direction[2] * V(axis[2])));
  }
  const V q_t = fma(hit.along[0], cone.t_u, hit.along[1] * cone.t_v);
  const V q_n = select(cone.below, hit.along[2], -hit.along[2]);
  const V q_x = fma(hit.along[1], cone.t_u, -(hit.along[0] * cone.t_v));
  const V q_y = fma(cone.m_n, q_t, -(cone.m_t * q_n));
  hit.x = q_x / cone.a;
  hit.y = q_y / cone.b;
  hit.z = fma(cone.m_t, q_t, cone.m_n * q_n);
  const V blur = constant<V>(8 * std::numeric_limits<Scalar<V>>::epsilon());
  const V x = max(abs(q_x) - blur, V(0)) / cone.a;
  const V y = max(abs(q_y) - blur, V(0)) / cone.b;
  hit.inside = cone.valid && (fma(x, x, y * y) <= V(1)) && (hit.z > -blur) && (q_n > -blur);
  return hit;
}

/// Likewise for a place on the disk, in radii: a sampled one is within 16 ulp of it.
template <class V>
inline Mask<V> on_disk(V s, V t) {
  return fma(s, s, t * t) <= constant<V>(1 + 32 * std::numeric_limits<Scalar<V>>::epsilon());
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
