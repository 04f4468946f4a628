// The public calls for rectangles.
#include "calls.h"
#include "dispatch.h"
#include "light_frame.h"

#include <hatbox/rectangle.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace hatbox {
namespace {

double length(const Vec3& v) { return std::sqrt(dot(in_double(v), in_double(v))); }

bool too_short(const Vec3& edge) { return length(edge) < static_cast<double>(std::numeric_limits<float>::min()); }

bool too_long(const Vec3& edge) { return length(edge) > static_cast<double>(std::numeric_limits<float>::max()); }

const MapKernels<RectangleConstants>& kernels_of(RectangleMap map) {
  return hatbox::kernels_of(active_kernels().rectangle, map, "RectangleMap");
}

}  // namespace

RectangleConstants ready(const Rectangle& light) {
  const std::string_view problem = check(light);
  if (problem.empty()) return constants_of<float>(light);
  throw std::invalid_argument(std::string(problem) + "; corner " + to_string(light.corner) + ", edge_u " +
                              to_string(light.edge_u) + ", edge_v " + to_string(light.edge_v));
}

std::string_view check(const Rectangle& light) noexcept {
  if (!is_finite(light.corner)) return "light.corner is not finite";
  if (!is_finite(light.edge_u)) return "light.edge_u is not finite";
  if (!is_finite(light.edge_v)) return "light.edge_v is not finite";
  if (too_short(light.edge_u)) return "light.edge_u is zero, or shorter than a normal float";
  if (too_short(light.edge_v)) return "light.edge_v is zero, or shorter than a normal float";
  if (too_long(light.edge_u)) return "light.edge_u is longer than a float";
  if (too_long(light.edge_v)) return "light.edge_v is longer than a float";
  const double cosine =
      dot(in_double(light.edge_u), in_double(light.edge_v)) / length(light.edge_u) / length(light.edge_v);
  if (std::abs(cosine) > 1e-4) return "light.edge_v is not perpendicular to edge_u";
  return {};
}

void sample(const Rectangle& light, RectangleMap map, Points points, Variates variates, Samples out) {
  call_sample({}, kernels_of(map), ready(light), points, variates, out);
}

void pdf(const Rectangle& light, RectangleMap map, Points points, Directions directions, std::span<float> out) {
  call_pdf({}, kernels_of(map), ready(light), points, directions, out);
}

void pdf(const Rectangle& light, RectangleMap map, Points points, Places places, std::span<float> out) {
  call_pdf({}, kernels_of(map), ready(light), points, places, out);
}

void invert(const Rectangle& light, RectangleMap map, Points points, Directions directions, std::span<float> u,
            std::span<float> v) {
  call_invert({}, kernels_of(map), ready(light), points, directions, u, v);
}

void solid_angle(const Rectangle& light, Points points, std::span<float> out) {
  call_solid_angle({}, active_kernels().rectangle.solid_angle, ready(light), points, out);
}

namespace parallel {

void sample(const Rectangle& light, RectangleMap map, Points points, Variates variates, Samples out,
            std::size_t grain) {
  call_sample(parallel_with(grain), kernels_of(map), ready(light), points, variates, out);
}

void pdf(const Rectangle& light, RectangleMap map, Points points, Directions directions, std::span<float> out,
         std::size_t grain) {
  call_pdf(parallel_with(grain), kernels_of(map), ready(light), points, directions, out);
}

void pdf(const Rectangle& light, RectangleMap map, Points points, Places places, std::span<float> out,
         std::size_t grain) {
  call_pdf(parallel_with(grain), kernels_of(map), ready(light), points, places, out);
}

void invert(const Rectangle& light, RectangleMap map, Points points, Directions directions, std::span<float> u,
            std::span<float> v, std::size_t grain) {
  call_invert(parallel_with(grain), kernels_of(map), ready(light), points, directions, u, v);
}

void solid_angle(const Rectangle& light, Points points, std::span<float> out, std::size_t grain) {
  call_solid_angle(parallel_with(grain), active_kernels().rectangle.solid_angle, ready(light), points, out);
}

}  // namespace parallel
}  // namespace hatbox
