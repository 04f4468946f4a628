// The disk maps of [GUK*17] (Guillén et al., Area-Preserving Parameterizations for Spherical Ellipses, 2017) in scalar
// double, straight from the paper's equations 3–15 and 16–23. Slow, and no better than the paper's form of the solid
// angle: equation 19 cancels for small ones (relative error about 1e-16 / solid angle). See disk_eta_reference.h.
#pragma once

#include "reference/disk_view.h"

namespace hatbox::reference {

/// A disk seen from a point.
class PaperDisk {
 public:
  PaperDisk(const DiskFrame<double>& frame, const Vec3& point);

  double solid_angle() const { return 4 * whole_; }
  DiskSample sample(DiskMap map, float u, float v) const;

  double sin_alpha() const { return a_; }
  double sin_beta() const { return b_; }
  double rim_radius(double phi) const;  // equation 18: sin θ(φ)

  /// The sample in a direction of the ellipse's own frame (z is its centre), with the density 1/Ω.
  DiskSample at(const Vector<double>& q) const { return view_.sample(from_ellipse(q.x, q.y, q.z), 1 / solid_angle()); }

  /// The Newton steps, at most 100, of the authors' published code for the radial map, as far as it can be told: it has
  /// no bracket, and the parametric angle's derivative in it lacks its squares.
  int published_steps(float u) const;

 private:
  double quadrant_area(double phi) const;  // equation 19
  double slice_height(double phi) const;   // equation 9
  double slices_area(double phi) const;    // equation 11
  Vector<double> radial_point(DiskMap map, double u, double v, int& iterations) const;
  Vector<double> parallel_point(double u, double v, int& iterations) const;
  Vector<double> from_ellipse(double x, double y, double z) const;

  DiskView<double> view_;
  double center_y_, center_z_;  // the centre of the ellipse, local coordinates
  double a_, b_;                // semi-axes: sin α, sin β
  double n_, k_;                // characteristic and modulus (√m) of equation 20
  double factor_;               // of Π in equation 19
  double tangent_ratio_;        // a_t / b_t
  double whole_;                // Ω_r(π/2)
  double tan_b_, slice_k_;      // b_t; the modulus of equation 10
};

}  // namespace hatbox::reference
