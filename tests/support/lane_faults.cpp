#include "support/lane_faults.h"

#include "support/bits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hatbox::test {
namespace {

constexpr double off_unit_length = 1e-6, off_the_light = 1e-5;

const char* fault_of_invalid(const SampleArrays& samples, std::size_t i) {
  for (const auto& column : samples.columns) {
    if (column[i] != 0) return "an invalid lane has an output that is not 0";
  }
  return nullptr;
}

/// Whether no distance to the light from here is too small for a normal float: the height above its plane is none, nor
/// what the rounding of an outline's axes can make of it.
bool is_clear(const Outline& light, const Vec3& point) {
  const auto normal = normalize(cross(light.along_s, light.along_t));  // NaN of a set, which has no outline
  const auto way = reference::convert<double>(point) - light.origin;
  return std::abs(dot(way, normal)) >= std::max<double>(std::numeric_limits<float>::min(), 1e-6 * length(way));
}

}  // namespace

const char* fault_of(const Sampler& sampler, const Vec3& point, const SampleArrays& samples, std::size_t i) {
  for (const auto& column : samples.columns) {
    if (!std::isfinite(column[i])) return "an output is not finite";
  }
  if (samples.at(SampleArrays::pdf, i) < 0) return "the pdf is negative";
  if (!samples.valid(i)) return fault_of_invalid(samples, i);
  if (std::abs(length(samples.direction(i)) - 1) > off_unit_length) return "the direction is not of unit length";
  const float distance = samples.at(SampleArrays::distance, i);
  if (distance < 0 || (distance == 0 && is_clear(sampler.outline, point))) return "the distance is not positive";
  if (std::abs(samples.at(SampleArrays::cosine, i)) > 1 + 1e-6f) return "the cosine is beyond 1";
  const double s = samples.at(SampleArrays::s, i), t = samples.at(SampleArrays::t, i);
  if (!sampler.outline.is_nowhere() && sampler.outline.beyond(s, t) > off_the_light)
    return "the place is outside of the light";
  return nullptr;
}

const char* fault_of_density(float density) {
  return std::isfinite(density) && density >= 0 ? nullptr : "pdf is no density";
}

const char* fault_of_inverse(float u, float v) {
  const bool inside = u >= 0 && u <= 1 && v >= 0 && v <= 1, missed = u == -1 && v == -1;
  return inside || missed ? nullptr : "the inverse is neither in the square nor -1, -1";
}

const char* fault_of_solid_angle(float omega) {
  const double most = 2 * std::numbers::pi * (1 + 2e-6);
  return omega >= 0 && omega <= most ? nullptr : "the solid angle is not between 0 and 2 pi";
}

const char* fault_of_distance(const reference::Segment& segment, float t, float pdf, float asked) {
  if (fault_of_density(pdf) || fault_of_density(asked)) return "a density is none";
  if (pdf == 0) return same_bits(t, 0) ? nullptr : "an invalid lane has a distance that is not 0";
  if (!(std::isfinite(t) && t >= segment.t_min && t <= segment.t_max)) return "the distance is beyond the segment";
  return same_bits(asked, pdf) ? nullptr : "pdf is not what sample said";
}

const char* fault_of_clipped(const reference::Segment& segment, float t_min, float t_max) {
  const bool nothing = same_bits(t_min, 0) && same_bits(t_max, 0);
  const bool part = t_min < t_max && t_min >= segment.t_min && t_max <= segment.t_max;
  return nothing || part ? nullptr : "what is left is no part of the segment";
}

}  // namespace hatbox::test
