// The ellipse maps in long double: the cone of an elliptical disk by one-sided J-Jacobi rotations, which has nothing in
// common with the kernels' confocal quadrics, and the spherical ellipse in its parametric angle. The tests hold it
// against golden values and, for circles, against the disk's reference.
#pragma once

#include "reference/disk_eta_reference.h"

#include <hatbox/ellipse.h>

namespace hatbox::reference {

/// An ellipse seen from a point that is not in its plane.
class EtaEllipse {
 public:
  EtaEllipse(const Ellipse& light, const Vec3& point);

  double solid_angle() const { return ellipse_.solid_angle(); }
  const SemiAxes& semi_axes() const { return ellipse_.axes(); }
  DiskSample sample(EllipseMap map, float u, float v) const;

  /// The point of the ellipse, for the solid-angle maps; t > 1 is outside the rim.
  DiskSample at(const EllipsePlace& place) const;

  /// Where a direction of any length lies on the ellipse.
  EllipsePlace locate(const Vector<double>& direction) const;

  /// Where the place (s, t) on the light lies on the ellipse.
  EllipsePlace locate(double s, double t) const;

  double pdf(EllipseMap map, const Vector<double>& direction) const;

 private:
  using Real = long double;

  /// Towards the light in world space: its axes made perpendicular, and the cone's.
  struct View {
    Vector<Real> to_center, axis_u, axis_v, normal;
    Vector<Real> x, y, z;
    SemiAxes semi_axes;
  };
  static View view(const Ellipse& light, const Vec3& point);
  EllipsePlace locate_unit(const Vector<Real>& unit) const;
  DiskSample describe(const Vector<Real>& unit, Real pdf) const;
  Real area_pdf(const Vector<Real>& unit) const;

  View view_;
  SphericalEllipse ellipse_;
};

}  // namespace hatbox::reference
