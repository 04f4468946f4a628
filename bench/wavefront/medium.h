// The fog: which part of a ray lies in it, and what of light gets through.
#pragma once

#include "scene.h"

namespace wavefront {

struct Interval {
  float begin, end;  // empty if begin >= end
};

/// The part of the ray within [0, end] that lies in the medium; `direction` is a unit vector, `end` may be infinite.
Interval inside(const Medium& medium, const V3f& origin, const V3f& direction, float end);

/// What gets through so much of the medium.
Rgb transmittance(const Medium& medium, float length);

/// One where there is no medium.
Rgb transmittance(const std::optional<Medium>& medium, const V3f& origin, const V3f& direction, float distance);

/// Of the channel that reaches farthest.
float lowest_extinction(const Medium& medium);

}  // namespace wavefront
