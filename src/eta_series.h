// The area-preserving map in the angle η of the orthographic ellipse, as an explicit sine series.
//
// Projected along its centre direction the spherical ellipse's rim is (a cos η, b sin η), at the height
//   h(η) = cos β · H(η),  H(η)² = k'² cos² η + sin² η,
// and the solid angle between the rim points of η and η + dη is a b dη/(1 + h) (Guillén et al. 2017, eq. 16-19 with
// their azimuth replaced by η). A uniform angle θ must therefore become η with dη/dθ ∝ 1 + h(η). The paper inverts the
// elliptic integral by Newton's method, for every sample; here
//   η(θ) = θ + ½ sin 2θ · P(cos 2θ)
// with a polynomial P found once per shading point: a fit where the rim is nearly flat (eta_fit.h), as it is for all
// but one in a thousand points around a disk; Fourier's and Lagrange's series next to the rim (eta_lagrange.h). Which
// of the two a lane takes, its own k' says; packets that have no lane for the second are spared it.
//
// The density reported for a sample is that of this very η(θ), from its exact derivative. So what fit and truncation
// cost is never bias, only a slight variation of the density over the light: of 3e-6 at 99.9 % of points around a disk.
#pragma once

#include "eta_fit.h"
#include "eta_lagrange.h"

namespace hatbox::HATBOX_ISA {
namespace {

template <class V>
struct AngleShift {
  V shift, slope;  // η − θ, dη/dθ
};

/// The way back, from an η.
template <class V>
struct UniformAngle {
  SinCos<V> angle;  // θ
  V slope;          // dη/dθ
};

/// η ↦ θ by Newton's method: |η − θ| < 0.15, three steps are exact to float everywhere, and the fourth is for the
/// slope there.
template <class AngleMap, class V>
inline UniformAngle<V> solve_uniform_angle(const AngleMap& map, const SinCos<V>& eta) {
  UniformAngle<V> out = {eta, V(1)};
  V back = V(0);  // θ − η
  for (int step = 0; step < 4; ++step) {
    const auto [shift, slope] = map(out.angle);
    back = back - (back + shift) / slope;
    out.slope = slope;
    out.angle = rotate(eta, sincos_small(back));
  }
  return out;
}

/// Made once a shading point. Any class with this constructor, call and way back can stand in its place (radial_map.h).
template <class V>
class EtaSeries {
 public:
  template <class Light>
  HATBOX_INLINE EtaSeries(const Light&, const SphericalEllipse<V>& cone);

  AngleShift<V> operator()(const SinCos<V>& theta) const;
  UniformAngle<V> uniform_angle(const SinCos<V>& eta) const { return solve_uniform_angle(*this, eta); }

 private:
  V p_[6];  // P, lowest power first
};

template <class V>
inline AngleShift<V> EtaSeries<V>::operator()(const SinCos<V>& theta) const {
  const auto [s, x] = doubled(theta);
  // by Estrin's scheme: half of Horner's to wait for
  const V xx = x * x, twice_x = x + x;
  const V value = fma(xx, fma(xx, fma(p_[5], x, p_[4]), fma(p_[3], x, p_[2])), fma(p_[1], x, p_[0]));
  const V derivative =
      fma(xx, fma(xx, V(5) * p_[5], fma(p_[4], twice_x + twice_x, V(3) * p_[3])), fma(p_[2], twice_x, p_[1]));
  // d/dθ [½ s P(x)] with x = cos 2θ, s = sin 2θ
  return {V(0.5) * s * value, fma(-(s * s), derivative, fma(x, value, V(1)))};
}

template <class V>
template <class Light>
HATBOX_INLINE inline EtaSeries<V>::EtaSeries(const Light&, const SphericalEllipse<V>& cone) {
  fitted_series(cone, p_);
  const Mask<V> sharp = cone.k2 < V(0.25);
  if (!any(sharp)) return;
  V p[6];
  lagrange_series(cone, p);
  for (int i = 0; i < 6; ++i) p_[i] = select(sharp, p[i], p_[i]);
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
