// DiskMap::rejection (Gamito 2016, "Solid Angle Sampling of Disk and Cylinder Lights"): uniform over the square about
// the disk, as seen (uniform_rectangle.h), until a point lies on the disk. So the points are uniform over the disk, and
// the density is 1/Ω of the disk; but (u, v) is not mapped continuously, and there is no inverse.
//
// The first candidate is (u, v) itself. Those after it come from a hash of the bits of u and v and the number of the
// try, not from a sequence that continues (u, v): which of its points are taken would depend on the light, and what is
// taken would no longer be uniform.
//
// The square's sides run along t̂, from the foot of the shading point to the disk's centre, and across it. So no corner
// of it comes near the foot but with the disk, and of its solid angle the disk has at least 0.752: at a distance of 2
// radii in the plane, in the limit of no height; π/4 from afar. Fifteen tries all fail with a probability below
// (1 − 0.752)^15 < 1e-9. Such a lane is invalid.
#pragma once

#include "disk_cone.h"
#include "hash.h"
#include "solid_angle.h"
#include "uniform_rectangle.h"

namespace hatbox::HATBOX_ISA {
namespace {

template <class V>
class DiskRejection {
 public:
  static constexpr int tries = 15;

  HATBOX_INLINE DiskRejection(const DiskLight<V>& light, V x, V y, V z)
      : cone_(light, x, y, z),
        scale_(power_of_two(largest(cone_))),
        square_(sides_of(cone_)),
        density_(cone_.valid, solid_angle_of(cone_)) {}

  HATBOX_INLINE LightSample<V> sample(V u, V v) const {
    Candidate taken = candidate(u, v);
    for (int i = 1; i < tries && any(density_.valid && !taken.on_disk); ++i) {
      const Square<V> hashed = hash_of(clamp_variate(u), clamp_variate(v), i);
      taken = chosen(taken.on_disk, taken, candidate(hashed.u, hashed.v));
    }
    LightSample<V> out = emit(taken);
    out.valid = density_.valid && taken.on_disk && square_.tells(taken.r) && is_finite(given(u, v) + out.distance);
    return out;
  }

  V pdf_of_place(const Place<V>& place) const { return density_.where(on_unit_disk(place)); }

  V pdf_of_direction(const V (&direction)[3]) const { return density_.where(cone_.hit(direction).inside); }

 private:
  struct Candidate {
    V tau, sigma;  // from the disk's centre along t̂ and n̂ × t̂, in radii
    V q_t, q_x;    // the direction along them
    V r, inverse_r;
    Mask<V> on_disk;
  };

  /// Of the square's coordinates.
  static V largest(const DiskCone<V>& cone) { return max(cone.d + V(1), cone.height); }

  static HATBOX_INLINE RectangleSides<V> sides_of(const DiskCone<V>& cone) {
    const V down = inverse_power_of_two(largest(cone)), height = cone.height * down;
    RectangleSides<V> sides;
    sides.x0 = cone.d2_minus_1 / (cone.d + V(1)) * down;  // d − 1
    sides.x1 = (cone.d + V(1)) * down;
    sides.y0 = -down;
    sides.y1 = down;
    sides.e_x = sides.e_y = V(2) * down;
    sides.height = height;
    sides.z = max(height, constant<V>(least_height));
    return sides;
  }

  HATBOX_INLINE Candidate candidate(V u, V v) const {
    const RectanglePoint<V> point = square_.point(shares_of(u), shares_of(v));
    const V offset = point.x.offset * scale_, tau = offset - V(1), sigma = point.y.value * scale_;
    return {tau,     sigma,           point.x.value * point.inverse_r,          point.y.value * point.inverse_r,
            point.r, point.inverse_r, sigma * sigma <= offset * (V(2) - offset)};
  }

  static HATBOX_INLINE Candidate chosen(Mask<V> first, const Candidate& a, const Candidate& b) {
    return {select(first, a.tau, b.tau), select(first, a.sigma, b.sigma), select(first, a.q_t, b.q_t),
            select(first, a.q_x, b.q_x), select(first, a.r, b.r),         select(first, a.inverse_r, b.inverse_r),
            first || b.on_disk};
  }

  HATBOX_INLINE LightSample<V> emit(const Candidate& point) const {
    const V t_u = cone_.t_u, t_v = cone_.t_v;
    const V q_n = square_.seen_height() * point.inverse_r;
    const V along[3] = {fma(point.q_t, t_u, -(point.q_x * t_v)), fma(point.q_t, t_v, point.q_x * t_u),
                        select(cone_.below, q_n, -q_n)};
    LightSample<V> out;
    set_direction(cone_.light.axes, along, out);
    out.distance = point.r * scale_ * V(cone_.light.radius);
    out.pdf = density_.value;
    out.place = {fma(point.tau, t_u, -(point.sigma * t_v)), fma(point.tau, t_v, point.sigma * t_u)};
    return out;
  }

  DiskCone<V> cone_;
  V scale_;  // radii in a scaled length
  UniformRectangle<V> square_;
  UniformDensity<V> density_;
};

}  // namespace
}  // namespace hatbox::HATBOX_ISA
