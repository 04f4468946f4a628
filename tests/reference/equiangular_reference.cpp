#include "reference/equiangular_reference.h"

namespace hatbox::reference {

Equiangular::Equiangular(const Segment& segment, const Vec3& pivot)
    : t_min_(static_cast<long double>(segment.t_min)), t_max_(static_cast<long double>(segment.t_max)) {
  const auto d = convert<long double>(segment.direction);
  const auto to_pivot = convert<long double>(pivot) - convert<long double>(segment.origin);
  foot_ = dot(to_pivot, d) / dot(d, d);
  distance_ = length(cross(to_pivot, d)) / dot(d, d);
  whole_ = angle(t_min_, t_max_);
}

/// θ(t) = atan((t − δ)/D), its difference between two places. On the ray itself, D = 0, what is proportional to it.
long double Equiangular::angle(long double from, long double to) const {
  const long double x = from - foot_, y = to - foot_;
  if (distance_ == 0) return 1 / x - 1 / y;
  // Arc tangents of large numbers differ by less than their rounding: then those of their inverses.
  if (x > distance_) return std::atan(distance_ / x) - std::atan(distance_ / y);
  if (y < -distance_) return std::atan(distance_ / x) - std::atan(distance_ / y);
  return std::atan(y / distance_) - std::atan(x / distance_);
}

double Equiangular::cdf(double t) const { return static_cast<double>(angle(t_min_, t) / whole_); }

double Equiangular::density(double t) const {
  const long double x = t - foot_;
  if (distance_ == 0) return static_cast<double>(1 / (whole_ * x * x));
  return static_cast<double>(distance_ / (whole_ * (distance_ * distance_ + x * x)));
}

double height(const Segment& segment, double t, const Vec3& on_plane, const Vec3& normal) {
  using Real = long double;
  const Vector<Real> n = convert<Real>(normal);
  const Vector<Real> from_plane = convert<Real>(segment.origin) - convert<Real>(on_plane);
  return static_cast<double>((dot(n, from_plane) + static_cast<Real>(t) * dot(n, convert<Real>(segment.direction))) /
                             length(n));
}

}  // namespace hatbox::reference
