// The radial map of [GUK17] in scalar float as a renderer would write it down from the paper: equations 3-5 and 16-22,
// inverted by safeguarded Newton. What tests/reference/disk_reference.h has in double, here to show what float loses.
#pragma once

#include <boost/math/special_functions/ellint_3.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hatbox::figures {

/// From the point to a place on the disk: x across, y along the way from the point's foot to the centre, z the height.
struct ToPlace {
  float x, y, z;
};

class PaperDiskFloat {
 public:
  /// Of radius 1, `offset` the distance of the point's foot from the centre.
  PaperDiskFloat(float offset, float height) : height_(height) {
    const float l0 = std::hypot(offset - 1, height), l1 = std::hypot(offset + 1, height);
    const float y0 = (offset - 1) / l0, z0 = height / l0;
    const float y1 = (offset + 1) / l1, z1 = height / l1;
    const float yh = (y0 + y1) / 2, zh = (z0 + z1) / 2;
    const float middle = std::hypot(yh, zh);
    center_y_ = yh / middle;
    center_z_ = zh / middle;
    const float chord_y = height * yh / zh, chord_x = std::sqrt(1 - (chord_y - offset) * (chord_y - offset));
    a_ = chord_x / std::sqrt(chord_x * chord_x + chord_y * chord_y + height * height);  // equation 4
    b_ = std::min(std::hypot(y1 - y0, z1 - z0) / 2, a_);
    const float a2 = a_ * a_, b2 = b_ * b_;
    n_ = (a2 - b2) / (a2 * (1 - b2));  // equation 20
    k_ = std::sqrt((a2 - b2) / (1 - b2));
    factor_ = b_ * (1 - a2) / (a_ * std::sqrt(1 - b2));
    tangent_ratio_ = a_ / b_ * std::sqrt((1 - b2) / (1 - a2));
    whole_ = quadrant_area(half_pi);
  }

  float solid_angle() const { return 4 * whole_; }

  ToPlace sample(float u, float v) const {
    const float turns = 4 * u, quadrant = std::floor(turns), rest = turns - quadrant;
    const int side = static_cast<int>(quadrant) & 3;
    const float phi = invert(side % 2 == 0 ? rest : 1 - rest);
    const float rim = rim_radius(phi);
    const float h = 1 - v * (1 - std::sqrt(1 - rim * rim));  // equation 22
    const float rho = std::sqrt(1 - h * h);
    const float x = (side == 1 || side == 2 ? -rho : rho) * std::cos(phi), y = (side >= 2 ? -rho : rho) * std::sin(phi);
    const float distance = height_ / (h * center_z_ - y * center_y_);
    return {distance * x, distance * (y * center_z_ + h * center_y_), height_};
  }

 private:
  static constexpr float half_pi = std::numbers::pi_v<float> / 2;

  /// Equation 19. Boost says by NaN (and soon) what it cannot do.
  float quadrant_area(float phi) const {
    using namespace boost::math::policies;
    using InFloat = policy<promote_float<false>, domain_error<ignore_error>, overflow_error<ignore_error>,
                           evaluation_error<ignore_error>, rounding_error<ignore_error>, max_series_iterations<100>>;
    if (!std::isfinite(n_ + k_ + factor_ + tangent_ratio_ + phi)) return std::numeric_limits<float>::quiet_NaN();
    if (phi == half_pi) return phi - factor_ * boost::math::ellint_3(k_, n_, InFloat());
    const float parametric = std::atan2(tangent_ratio_ * std::sin(phi), std::cos(phi));
    return phi - factor_ * boost::math::ellint_3(k_, n_, parametric, InFloat());
  }

  /// Equation 18.
  float rim_radius(float phi) const { return a_ * b_ / std::hypot(a_ * std::sin(phi), b_ * std::cos(phi)); }

  /// Equation 21, for a share of the quadrant.
  float invert(float share) const {
    float low = 0, high = half_pi;
    float phi = std::atan2(b_ * std::sin(share * half_pi), a_ * std::cos(share * half_pi));
    for (int step = 0; step < 50; ++step) {
      const float off = quadrant_area(phi) - share * whole_, rim = rim_radius(phi);
      (off > 0 ? high : low) = phi;
      float next = phi - off / (1 - std::sqrt(1 - rim * rim));
      if (std::isnan(off)) return off;
      if (!(next >= low && next <= high)) next = (low + high) / 2;
      const bool done = std::abs(next - phi) <= 1e-6f * phi;
      phi = next;
      if (done) break;
    }
    return phi;
  }

  float height_, center_y_, center_z_, a_, b_, n_, k_, factor_, tangent_ratio_, whole_ = 0;
};

}  // namespace hatbox::figures
