// The public calls for ellipses.
#include "calls.h"
#include "dispatch.h"
#include "light_frame.h"

#include <hatbox/ellipse.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace hatbox {
namespace {

const MapKernels<EllipseConstants>& kernels_of(EllipseMap map) {
  return hatbox::kernels_of(active_kernels().ellipse, map, "EllipseMap");
}

}  // namespace

EllipseConstants ready(const Ellipse& light) {
  const std::string_view problem = check(light);
  if (problem.empty()) return constants_of<float>(light);
  throw std::invalid_argument(std::string(problem) + "; center " + to_string(light.center) + ", semi_axis_u " +
                              to_string(light.semi_axis_u) + ", semi_axis_v " + to_string(light.semi_axis_v));
}

std::string_view check(const Ellipse& light) noexcept {
  constexpr double longest = std::numeric_limits<float>::max(), least_ratio = 1e-6, largest_cosine = 1e-4;
  if (!is_finite(light.center)) return "light.center is not finite";
  if (!is_finite(light.semi_axis_u)) return "light.semi_axis_u is not finite";
  if (!is_finite(light.semi_axis_v)) return "light.semi_axis_v is not finite";
  // In double no length or product of floats over- or underflows.
  const Double3 axis_u = in_double(light.semi_axis_u), axis_v = in_double(light.semi_axis_v);
  const double u = std::sqrt(dot(axis_u, axis_u)), v = std::sqrt(dot(axis_v, axis_v));
  if (u == 0) return "light.semi_axis_u is zero";
  if (v == 0) return "light.semi_axis_v is zero";
  if (u > longest) return "light.semi_axis_u is longer than the largest float";
  if (v > longest) return "light.semi_axis_v is longer than the largest float";
  if (u < least_ratio * v) return "light.semi_axis_u is shorter than 1e-6 of light.semi_axis_v";
  if (v < least_ratio * u) return "light.semi_axis_v is shorter than 1e-6 of light.semi_axis_u";
  if (std::abs(dot(axis_u, axis_v)) > largest_cosine * u * v) {
    return "light.semi_axis_v is not perpendicular to light.semi_axis_u";
  }
  return {};
}

void sample(const Ellipse& light, EllipseMap map, Points points, Variates variates, Samples out) {
  call_sample({}, kernels_of(map), ready(light), points, variates, out);
}

void pdf(const Ellipse& light, EllipseMap map, Points points, Directions directions, std::span<float> out) {
  call_pdf({}, kernels_of(map), ready(light), points, directions, out);
}

void pdf(const Ellipse& light, EllipseMap map, Points points, Places places, std::span<float> out) {
  call_pdf({}, kernels_of(map), ready(light), points, places, out);
}

void invert(const Ellipse& light, EllipseMap map, Points points, Directions directions, std::span<float> u,
            std::span<float> v) {
  call_invert({}, kernels_of(map), ready(light), points, directions, u, v);
}

void solid_angle(const Ellipse& light, Points points, std::span<float> out) {
  call_solid_angle({}, active_kernels().ellipse.solid_angle, ready(light), points, out);
}

namespace parallel {

void sample(const Ellipse& light, EllipseMap map, Points points, Variates variates, Samples out, std::size_t grain) {
  call_sample(parallel_with(grain), kernels_of(map), ready(light), points, variates, out);
}

void pdf(const Ellipse& light, EllipseMap map, Points points, Directions directions, std::span<float> out,
         std::size_t grain) {
  call_pdf(parallel_with(grain), kernels_of(map), ready(light), points, directions, out);
}

void pdf(const Ellipse& light, EllipseMap map, Points points, Places places, std::span<float> out, std::size_t grain) {
  call_pdf(parallel_with(grain), kernels_of(map), ready(light), points, places, out);
}

void invert(const Ellipse& light, EllipseMap map, Points points, Directions directions, std::span<float> u,
            std::span<float> v, std::size_t grain) {
  call_invert(parallel_with(grain), kernels_of(map), ready(light), points, directions, u, v);
}

void solid_angle(const Ellipse& light, Points points, std::span<float> out, std::size_t grain) {
  call_solid_angle(parallel_with(grain), active_kernels().ellipse.solid_angle, ready(light), points, out);
}

}  // namespace parallel
}  // namespace hatbox
