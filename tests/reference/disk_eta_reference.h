// The disk maps in a form that keeps its precision from 2π down to the smallest solid angle: the cone of the disk
// without cancellation, in long double, and the spherical ellipse in its parametric angle. This is what the float
// kernels are measured against; the tests hold it against the paper's own equations where those are good.
#pragma once

#include "reference/disk_view.h"
#include "reference/spherical_ellipse.h"

namespace hatbox::reference {

/// The coordinates (θ, t) of a direction on the ellipse: its solid-angle measure is Ω dθ dt / 2π, t <= 1 inside.
struct EllipsePlace {
  double theta, t;
};

/// A disk seen from a point that is not in its plane.
class EtaDisk {
 public:
  EtaDisk(const DiskFrame<long double>& frame, const Vec3& point);

  double solid_angle() const { return ellipse_.solid_angle(); }
  const SemiAxes& semi_axes() const { return ellipse_.axes(); }
  DiskSample sample(DiskMap map, float u, float v) const;

  /// The point of the ellipse, for the solid-angle maps; t > 1 is outside the rim.
  DiskSample at(const EllipsePlace& place) const;

  /// Where a direction of any length lies on the ellipse.
  EllipsePlace locate(const Vector<double>& direction) const;

  /// Where the place (s, t) on the light lies on the ellipse.
  EllipsePlace locate(double s, double t) const;

  double pdf(DiskMap map, const Vector<double>& direction) const;

 private:
  using Real = long double;
  using Local = Vector<Real>;
  Local from_ellipse(const EllipsePlace& place, int& iterations) const;
  Local from_slice(double u, double v, int& iterations) const;
  Local from_frame(Real x, Real y, Real z) const;
  EllipsePlace locate_local(const Local& direction) const;

  DiskView<long double> view_;
  SphericalEllipse ellipse_;
  long double center_y_, center_z_;  // the centre of the ellipse, local coordinates
};

}  // namespace hatbox::reference
