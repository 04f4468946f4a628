// The area of a spherical ellipse as integrals over the parametric angle η of its orthographic projection, where
// nothing cancels, so that they keep double's precision for every size. By Gauss–Legendre panels; no elliptic integral
// is involved.
//
// From the centre outwards dΩ/dη = ab / (1 + h(η)), h² = cos²α cos²η + cos²β sin²η: the same as equations 16–19 of
// [GUK*17]. In slices dΩ/dη = 2ab cos²α cos²η / (h (cos²α cos²η + sin²η)): the same as equations 6–12.
#pragma once

#include "reference/panel_integral.h"

namespace hatbox::reference {

struct SemiAxes {
  double a, b;                 // sin α >= sin β > 0
  double cos_alpha, cos_beta;  // given apart, since the sines alone cannot tell a nearly full hemisphere
};

class SphericalEllipse {
 public:
  explicit SphericalEllipse(const SemiAxes& axes);

  double solid_angle() const { return 4 * axes_.a * axes_.b * sectors_.whole(); }
  const SemiAxes& axes() const { return axes_; }

  /// Height of the rim above the plane through the centre of the sphere.
  double rim_height(double eta) const;

  /// The share of the area below η as an angle: 2π·Ω(η)/Ω. Odd, and θ(η + π) = θ(η) + π.
  double theta(double eta) const;

  /// The inverse of `theta`, to 1e-14; adds the Newton steps taken to `iterations`.
  double eta(double theta, int& iterations) const;

  /// Where the slice ends that has the share `u` of the area below it: −π/2 <= η <= π/2 for 0 <= u <= 1.
  double slice_eta(double u, int& iterations) const;

 private:
  SemiAxes axes_;
  PanelIntegral sectors_, slices_;
};

}  // namespace hatbox::reference
