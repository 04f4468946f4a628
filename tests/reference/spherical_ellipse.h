// The area of a spherical ellipse as an integral over the parametric angle η of its orthographic projection:
// dΩ/dη = ab / (1 + h(η)), h² = cos²α cos²η + cos²β sin²η. The same as equations 16–19 of [GUK*17], but nothing
// cancels, so it keeps double's precision for every size. By Gauss–Legendre panels; no elliptic integral is involved.
#pragma once

#include <vector>

namespace hatbox::reference {

struct SemiAxes {
  double a, b;                 // sin α >= sin β > 0
  double cos_alpha, cos_beta;  // given apart, since the sines alone cannot tell a nearly full hemisphere
};

class SphericalEllipse {
 public:
  explicit SphericalEllipse(const SemiAxes& axes);

  double solid_angle() const { return 4 * axes_.a * axes_.b * sums_.back(); }
  const SemiAxes& axes() const { return axes_; }

  /// Height of the rim above the plane through the centre of the sphere.
  double rim_height(double eta) const;

  /// The share of the area below η as an angle: 2π·Ω(η)/Ω. Odd, and θ(η + π) = θ(η) + π.
  double theta(double eta) const;

  /// The inverse of `theta`, to 1e-14; adds the Newton steps taken to `iterations`.
  double eta(double theta, int& iterations) const;

 private:
  double density(double eta) const { return 1 / (1 + rim_height(eta)); }
  double first_quadrant_theta(double eta) const;
  double first_quadrant_eta(double theta, int& iterations) const;

  SemiAxes axes_;
  std::vector<double> ends_;  // of the panels, 0 … π/2
  std::vector<double> sums_;  // ∫ dη/(1+h) from 0 to each end
};

}  // namespace hatbox::reference
