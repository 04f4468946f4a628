// The public calls for triangles.
#include "calls.h"
#include "dispatch.h"

#include <hatbox/triangle.h>

#include <limits>
#include <stdexcept>
#include <string>

namespace hatbox {
namespace {

const MapKernels<TriangleConstants>& kernels_of(TriangleMap map) {
  return hatbox::kernels_of(active_kernels().triangle, map, "TriangleMap");
}

}  // namespace

TriangleConstants ready(const Triangle& light) {
  const std::string_view problem = check(light);
  if (problem.empty()) return constants_of<float>(light);
  throw std::invalid_argument(std::string(problem) + "; a " + to_string(light.a) + ", b " + to_string(light.b) +
                              ", c " + to_string(light.c));
}

std::string_view check(const Triangle& light) noexcept {
  if (!is_finite(light.a)) return "light.a is not finite";
  if (!is_finite(light.b)) return "light.b is not finite";
  if (!is_finite(light.c)) return "light.c is not finite";
  if (longest_side(light) > std::numeric_limits<float>::max()) return "light.a, b and c are too far apart";
  if (thinness(light) < 0x1p-24) return "light.a, b and c lie on a line";
  return {};
}

void sample(const Triangle& light, TriangleMap map, Points points, Variates variates, Samples out) {
  call_sample({}, kernels_of(map), ready(light), points, variates, out);
}

void pdf(const Triangle& light, TriangleMap map, Points points, Directions directions, std::span<float> out) {
  call_pdf({}, kernels_of(map), ready(light), points, directions, out);
}

void pdf(const Triangle& light, TriangleMap map, Points points, Places places, std::span<float> out) {
  call_pdf({}, kernels_of(map), ready(light), points, places, out);
}

void invert(const Triangle& light, TriangleMap map, Points points, Directions directions, std::span<float> u,
            std::span<float> v) {
  call_invert({}, kernels_of(map), ready(light), points, directions, u, v);
}

void solid_angle(const Triangle& light, Points points, std::span<float> out) {
  call_solid_angle({}, active_kernels().triangle.solid_angle, ready(light), points, out);
}

namespace parallel {

void sample(const Triangle& light, TriangleMap map, Points points, Variates variates, Samples out, std::size_t grain) {
  call_sample(parallel_with(grain), kernels_of(map), ready(light), points, variates, out);
}

void pdf(const Triangle& light, TriangleMap map, Points points, Directions directions, std::span<float> out,
         std::size_t grain) {
  call_pdf(parallel_with(grain), kernels_of(map), ready(light), points, directions, out);
}

void pdf(const Triangle& light, TriangleMap map, Points points, Places places, std::span<float> out,
         std::size_t grain) {
  call_pdf(parallel_with(grain), kernels_of(map), ready(light), points, places, out);
}

void invert(const Triangle& light, TriangleMap map, Points points, Directions directions, std::span<float> u,
            std::span<float> v, std::size_t grain) {
  call_invert(parallel_with(grain), kernels_of(map), ready(light), points, directions, u, v);
}

void solid_angle(const Triangle& light, Points points, std::span<float> out, std::size_t grain) {
  call_solid_angle(parallel_with(grain), active_kernels().triangle.solid_angle, ready(light), points, out);
}

}  // namespace parallel
}  // namespace hatbox
