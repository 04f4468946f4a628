// Equiangular sampling as Kulla and Fajardo 2012 have it, by differences of arc tangents in long double, and the same
// of a segment clipped by a plane.
#pragma once

#include "reference/vector.h"

#include <hatbox/lights.h>

namespace hatbox::reference {

/// A segment of a ray. The direction may have any length: t is in units of it.
struct Segment {
  Vec3 origin, direction;
  float t_min, t_max;
};

class Equiangular {
 public:
  Equiangular(const Segment& segment, const Vec3& pivot);

  /// The probability of a distance up to t.
  double cdf(double t) const;

  /// The density at t, wherever that is.
  double density(double t) const;

  double foot() const { return static_cast<double>(foot_); }          ///< t next to the pivot
  double distance() const { return static_cast<double>(distance_); }  ///< of the pivot from the ray, in units of t

 private:
  long double angle(long double from, long double to) const;

  long double foot_, distance_, t_min_, t_max_, whole_;
};

/// The height of origin + t·direction above a plane, over the length of the normal.
double height(const Segment& segment, double t, const Vec3& on_plane, const Vec3& normal);

}  // namespace hatbox::reference
