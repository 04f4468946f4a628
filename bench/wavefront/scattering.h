// How light is scattered where it is gathered: by a Lambertian surface or by the medium.
#pragma once

#include "sampler.h"
#include "scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace wavefront {

/// A density of directions about an axis. What scatters does so in proportion to the very density by which directions
/// are sampled: a Lambertian surface to cos/π about its normal (the cosine of the rendering equation included), a
/// medium to Henyey and Greenstein's phase function (1941) about the direction of the camera ray.
struct Scattering {
  bool surface;
  float g = 0;

  float density(float cosine) const {
    if (surface) return std::max(cosine, 0.0f) * std::numbers::inv_pi_v<float>;
    const float s = 1 + g * g - 2 * g * cosine;
    return (1 - g * g) / (4 * std::numbers::pi_v<float> * s * std::sqrt(s));
  }

  V3f sample(const V3f& axis, const Sample2& sample) const {
    const float cosine = surface ? std::sqrt(1 - sample.x) : phase_cosine(sample.x);
    const float sine = std::sqrt(std::max(1 - cosine * cosine, 0.0f));
    const float angle = 2 * std::numbers::pi_v<float> * sample.y;
    // Duff et al. 2017, "Building an Orthonormal Basis, Revisited".
    const float sign = std::copysign(1.0f, axis.z);
    const float a = -1 / (sign + axis.z), b = axis.x * axis.y * a;
    const V3f u(1 + sign * axis.x * axis.x * a, sign * b, -sign * axis.x);
    const V3f v(b, sign + axis.y * axis.y * a, -axis.y);
    return (axis * cosine + (u * std::cos(angle) + v * std::sin(angle)) * sine).normalized();
  }

 private:
  float phase_cosine(float u) const {
    const float w = 1 - 2 * u;
    if (std::abs(g) < 1e-3f) return -w + 1.5f * g * (1 - w * w);  // the next term is of the order of g²
    const float s = (1 - g * g) / (1 - g * w);
    return std::clamp((1 + g * g - s * s) / (2 * g), -1.0f, 1.0f);
  }
};

}  // namespace wavefront
