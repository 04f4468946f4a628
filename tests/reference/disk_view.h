// A disk as it is seen from a point: its own coordinates, its place on the sphere, and the ways between them. Shared by
// the references; `Real` decides what the subtraction of world coordinates may cost (long double costs nothing here).
//
// Local coordinates: x along n̂ × t̂, y along t̂ (in the disk's plane, from the foot of the point to the centre), z from
// the point to the plane of the disk.
#pragma once

#include "reference/vector.h"

#include <hatbox/disk.h>

#include <numbers>

namespace hatbox::reference {

/// Whether u picks a slice and v the place along it; the other solid-angle maps go from the centre to the rim.
inline bool is_parallel(DiskMap map) { return map == DiskMap::parallel || map == DiskMap::parallel_carlson; }

/// What a reference says of one sample.
struct DiskSample {
  Vector<double> direction;
  double distance, pdf, s, t, cosine;
  int iterations = 0;  // of the numerical inversion
};

/// The axes of the light, orthogonalised once more so that the rounding of `axes` stays within the plane.
template <class Real>
struct DiskFrame {
  explicit DiskFrame(const Disk& light)
      : center(convert<Real>(light.center)), normal(normalize(convert<Real>(light.normal))), radius(light.radius) {
    const Axes given = axes(light);
    const auto u = convert<Real>(given.u);
    axis_u = normalize(u - dot(u, normal) * normal);
    axis_v = cross(normal, axis_u);
    if (dot(axis_v, convert<Real>(given.v)) < 0) axis_v = Real(-1) * axis_v;
  }

  Vector<Real> center, normal, axis_u, axis_v;  // all but the centre of unit length
  Real radius;
};

template <class Real>
class DiskView {
 public:
  DiskView(const DiskFrame<Real>& frame, const Vec3& point) : frame_(frame) {
    const Vector<Real> to_center = frame.center - convert<Real>(point);
    const Real signed_height = dot(to_center, frame.normal);
    const Vector<Real> in_plane = to_center - signed_height * frame.normal;
    side_ = signed_height < 0 ? Real(-1) : Real(1);
    height_ = std::abs(signed_height);
    offset_ = length(in_plane);
    towards_ = offset_ > 0 ? (1 / offset_) * in_plane : frame.axis_u;
    across_ = cross(frame.normal, towards_);
  }

  Real height() const { return height_; }  // above the plane of the disk
  Real offset() const { return offset_; }  // from the foot of the point to the centre
  Real radius() const { return frame_.radius; }

  Vector<Real> to_world(const Vector<Real>& p) const {
    return p.x * across_ + p.y * towards_ + (side_ * p.z) * frame_.normal;
  }
  Vector<Real> to_local(const Vector<Real>& p) const {
    return {dot(p, across_), dot(p, towards_), side_ * dot(p, frame_.normal)};
  }

  /// The unit local direction to a place on the light.
  Vector<Real> direction_to_place(Real s, Real t) const {
    const Vector<Real> place = (radius() * s) * frame_.axis_u + (radius() * t) * frame_.axis_v;
    return normalize(Vector<Real>{dot(place, across_), offset_ + dot(place, towards_), height_});
  }

  /// Everything that follows from a unit local direction.
  DiskSample sample(const Vector<Real>& direction, Real pdf) const {
    const Real distance = height_ / direction.z;
    const Vector<Real> place = (distance * direction.x) * across_ + (distance * direction.y - offset_) * towards_;
    return {.direction = convert<double>(to_world(direction)),
            .distance = static_cast<double>(distance),
            .pdf = static_cast<double>(pdf),
            .s = static_cast<double>(dot(place, frame_.axis_u) / radius()),
            .t = static_cast<double>(dot(place, frame_.axis_v) / radius()),
            .cosine = static_cast<double>(-side_ * direction.z)};
  }

  /// Density of a unit local direction when the disk is sampled uniformly in area: ‖o − x‖² / (A cos), with the square.
  Real area_pdf(const Vector<Real>& direction) const {
    const Real distance = height_ / direction.z;
    return distance * distance / (std::numbers::pi_v<Real> * radius() * radius() * direction.z);
  }

 private:
  DiskFrame<Real> frame_;
  Vector<Real> towards_, across_;
  Real side_, height_, offset_;
};

}  // namespace hatbox::reference
