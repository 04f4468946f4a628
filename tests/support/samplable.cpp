#include "support/samplable.h"

#include <algorithm>
#include <cmath>

namespace hatbox::test {
namespace {

constexpr double least_length = 1e-18, greatest_length = 1e18;

double largest_coordinate(const reference::Vector<double>& p) {
  return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

}  // namespace

Samplable::Samplable(const Outline& outline) {
  const auto [s, t] = outline.middle();
  const auto across = cross(outline.along_s, outline.along_t);
  origin_ = outline.origin;
  middle_ = s * outline.along_s + t * outline.along_t;
  normal_ = normalize(across);
  size_ = std::max(length(outline.along_s), length(outline.along_t));
  area_ = length(across) / 2;  // half of a rectangle, less of a disk: no more than there is
  ordinary_ = size_ < greatest_length && area_ / size_ > least_length &&
              largest_coordinate(origin_ + middle_) < greatest_length;
}

bool Samplable::from(const Vec3& point, double least_height) const {
  const auto p = reference::convert<double>(point);
  if (!ordinary_ || !(largest_coordinate(p) < greatest_length)) return false;
  const auto way = (p - origin_) - middle_;  // in this order it is right for a light far from the origin too
  const double distance = length(way), height = std::abs(dot(way, normal_));
  if (!(height > 1e-6 * distance && height > least_length && height > least_height * size_)) return false;
  if (!(distance > 1e-6 * size_ && distance < 1e6 * size_)) return false;
  const double farthest = distance + 2 * size_;
  const double least_solid_angle = area_ * height / (farthest * farthest * farthest);
  const double least_density = height * height / (4 * area_);
  return least_solid_angle > 1e-30 && least_density > 1e-30;
}

bool Samplable::by(float u, float v) { return std::isfinite(u) && std::isfinite(v); }

}  // namespace hatbox::test
