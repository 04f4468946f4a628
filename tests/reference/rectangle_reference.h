// A rectangle's solid angle and spherical map to 33 digits, of which the formulas of Ureña et al. 2013 leave enough.
#pragma once

#include "reference/sph_quad.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <cstdint>

namespace hatbox::reference {

using Quad = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<113, boost::multiprecision::digit_base_2, void, std::int16_t, -16382, 16383>,
    boost::multiprecision::et_off>;

/// A sample of a rectangle as it should be.
struct RectangleSample {
  Vector<long double> direction;  // world space, unit length
  long double s, t;
};

class RectangleReference {
 public:
  RectangleReference(const Rectangle& light, const Vec3& point);

  long double solid_angle() const { return static_cast<long double>(quad_.S); }
  RectangleSample sample(float u, float v) const;

  /// The unit direction to a place, world space.
  Vector<long double> direction(long double s, long double t) const;

  /// The largest angle between the directions to two corners.
  long double diameter() const;

 private:
  Vector<Quad> axes_[3];  // unit vectors
  Quad length_[2];
  Vector<Quad> to_corner_;  // from the shading point
  SphQuad<Quad> quad_;
};

}  // namespace hatbox::reference
