// The parallel map (Guillén et al. 2017, §3.2) over any cone whose spherical ellipse is known (disk_cone.h): u picks a
// slice, cut by a plane through the x̂_e axis, v the place along it.
//
// With sin φ_p = sin β sin χ (slice_area.h) eq. 9, 14 and 15 become, for τ = 2v − 1 and a point (a x, b y, z),
//   x = τ cos χ/n,  n² = 1 − a² sin² χ = cos² χ + cos² α sin² χ
//   y = sin χ ρ,  z = cos φ_p ρ,  ρ² = 1 − (a x)²
// so that 1 − x² − y² = (1 − τ²) cos² χ. No difference is left in any of them.
//
// Short slices make the map singular at its two ends, where all of v meets in a point; it is continuous there.
#pragma once

#include "disk_cone.h"
#include "slice_area.h"

namespace hatbox::HATBOX_ISA {
namespace {

/// Made once a point; its samples and queries share that.
template <class Cone>
class ParallelMap {
 public:
  using V = typename Cone::Vector;

  template <class Light>
  HATBOX_INLINE ParallelMap(const Light& light, V x, V y, V z) : cone_(light, x, y, z), area_(cone_) {}

  HATBOX_INLINE LightSample<V> sample(V u, V v) const {
    // The ends of the pattern are an ulp inside the rim, like the edges of the other maps.
    const V edge = constant<V>(std::numeric_limits<Scalar<V>>::epsilon());
    const Mask<V> upper = u > V(0.5);
    const V share = max(V(2) * min(min(u, V(1) - u), V(0.5)), edge);
    const Slices<V> slices = area_.upto(octants_of(share));
    const V tau = max(min(fma(V(2), v, V(-1)), V(1) - edge), edge - V(1));

    LightSample<V> out;
    cone_.emit(point_of({select(upper, slices.zeta.cos, -slices.zeta.cos), slices.zeta.sin}, tau), out);
    out.pdf = area_.density() * slices.weight;
    out.valid = honest(cone_.valid && is_finite(given(u, v) + out.distance), out.pdf);
    return out;
  }

  V pdf_of_place(const Place<V>& place) const { return pdf(cone_.chi_of(place), on_unit_disk(place)); }

  V pdf_of_direction(const V (&direction)[3]) const {
    const EllipseHit<V> q = cone_.hit(direction);
    return pdf(chi_of(q), q.inside);
  }

  Square<V> invert(const V (&direction)[3]) const {
    const EllipseHit<V> q = cone_.hit(direction);
    const SinCos<V> chi = chi_of(q);
    const Slices<V> slices = slices_of(chi);
    const V from_end = V(0.5) * min(area_.share(slices), V(1));
    const V u = select(chi.sin > V(0), V(1) - from_end, from_end);
    const Mask<V> at_end = !(chi.cos > V(0));  // where any v is right
    const V tau = q.x * slice_norm(chi) / select(at_end, V(1), chi.cos);
    const V v = fma(V(0.5), select(at_end, V(0), tau), V(0.5));
    const Mask<V> hit = honest(q.inside, area_.density()) && is_finite(u + v);
    return {select(hit, clamp_variate(u), V(-1)), select(hit, clamp_variate(v), V(-1))};
  }

 private:
  V cos_alpha() const { return sqrt(cone_.k2) * cone_.cos_beta; }

  /// n
  V slice_norm(const SinCos<V>& chi) const {
    const V height = cos_alpha() * chi.sin;
    return sqrt(fma(chi.cos, chi.cos, height * height));
  }

  // Eq. 13, in three steps for all lanes. Two leave 1e-12 around a disk, relative, but 5e-4 next to its rim, where the
  // third leaves 1e-7. Newton's own steps need four.
  HATBOX_INLINE V octants_of(V share) const {
    SliceBracket<V> bracket = area_.first_guess(share);
    for (int step = 0; step < 3; ++step) bracket = area_.better_guess(bracket, share);
    return bracket.guess;
  }

  HATBOX_INLINE EllipsePoint<V> point_of(const SinCos<V>& chi, V tau) const {
    const V n = slice_norm(chi);
    const V x = tau * chi.cos / n;
    const V short_of_end = (V(1) - abs(tau)) * (V(1) + abs(tau));
    const V inwards = chi.cos * chi.cos * short_of_end;
    // 1 − (a x)² = cos² α + a² (1 − x²), and n² (1 − x²) is a sum too.
    const V low = cos_alpha();
    const V rise = fma(low * chi.sin, low * chi.sin, inwards) / (n * n);
    const V rho = sqrt(fma(low, low, cone_.a * cone_.a * rise));
    const V b_cos = cone_.b * chi.cos;
    const V cos_phi = sqrt(fma(cone_.cos_beta, cone_.cos_beta, b_cos * b_cos));
    return ellipse_point(x, chi.sin * rho, cos_phi * rho, inwards);
  }

  /// Of the slice through a direction: sin χ = sin φ_p/sin β.
  SinCos<V> chi_of(const EllipseHit<V>& q) const {
    const V b_y = cone_.b * q.y;
    const V sin = max(min(q.y / sqrt(fma(b_y, b_y, q.z * q.z)), V(1)), V(-1));
    return {sin, sqrt((V(1) - abs(sin)) * (V(1) + abs(sin)))};
  }

  HATBOX_INLINE Slices<V> slices_of(const SinCos<V>& chi) const {
    const V sin = abs(chi.sin);
    const Mask<V> low = chi.cos < sin;
    const V octant = constant<V>(4 / pi) * atan_unit(select(low, chi.cos, sin) / select(low, sin, chi.cos));
    // No sample lies nearer to an end; rounding may take a query there, where squares would underflow.
    const V nearest = constant<V>(0.25 * std::numeric_limits<Scalar<V>>::epsilon());
    return area_.upto(max(select(low, octant, V(2) - octant), nearest));
  }

  V pdf(const SinCos<V>& chi, Mask<V> hit) const {
    const V p = area_.density() * slices_of(chi).weight;
    return select(honest(hit && cone_.valid, p), p, V(0));
  }

  Cone cone_;
  SliceArea<V> area_;
};

}  // namespace
}  // namespace hatbox::HATBOX_ISA
