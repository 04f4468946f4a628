#include "ray_weights.h"

#include <cmath>
#include <numbers>

namespace wavefront {

void RayWeights::Scratch::fill(std::size_t n, const LightFacts& light) {
  for (auto* columns : {&pivots, &normals}) columns->resize(n);
  for (auto* column : {&begin, &end, &distance, &pdf}) column->resize(n);
  u.assign(n, 0.5f);
  for (std::size_t i = 0; i < n; ++i) {
    pivots.set(i, light.centre);
    normals.set(i, light.normal);
  }
}

void RayWeights::operator()(std::uint32_t index, std::size_t begin, std::span<float> out) {
  const LightFacts& light = lights_[index];
  const std::size_t n = out.size();
  Scratch& scratch = scratch_.local();
  scratch.fill(n, light);
  const auto part = [&](std::span<const float> all) { return all.subspan(begin, n); };
  const hatbox::Segments all = rays_.segments();
  hatbox::Segments rays{part(all.x),  part(all.y),  part(all.z),     part(all.dx),
                        part(all.dy), part(all.dz), part(all.t_min), part(all.t_max)};
  if (!light.double_sided) {
    hatbox::equiangular::clip(rays, scratch.pivots.points(), scratch.normals.directions(), scratch.begin, scratch.end);
    rays.t_min = scratch.begin;
    rays.t_max = scratch.end;
  }
  hatbox::equiangular::sample(rays, scratch.pivots.points(), scratch.u, scratch.distance, scratch.pdf);
  for (std::size_t i = 0; i < n; ++i) {
    const V3f way = rays_.origin[begin + i] + rays_.direction[begin + i] * scratch.distance[i] - light.centre;
    const float length = std::max(rays.t_max[i] - rays.t_min[i], 0.0f);
    const float most = 2 * std::numbers::pi_v<float> * length;
    const float inverse = scratch.pdf[i] * way.length2();
    out[i] = light.luminance * (inverse * most > light.area ? light.area / inverse : most);
  }
}

}  // namespace wavefront
