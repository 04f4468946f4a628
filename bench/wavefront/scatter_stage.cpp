#include "scatter_stage.h"

#include "medium.h"
#include "parallel.h"

#include <limits>

namespace wavefront {
namespace {

constexpr float lost = std::numeric_limits<float>::infinity();
constexpr float just_behind = 1 + 0x1p-16f;

}  // namespace

void ScatterStage::Rays::resize(std::size_t n) {
  for (auto* column : {&vertex, &light, &placed}) column->resize(n);
  for (auto* column : {&position, &direction}) column->resize(n);
  for (auto* column : {&distance, &scattered}) column->resize(n);
  total.resize(n);
  radiance.resize(n);
}

void ScatterStage::Rays::copy(std::size_t from, std::size_t to) {
  for (auto* column : {&vertex, &light, &placed}) (*column)[to] = (*column)[from];
  for (auto* column : {&position, &direction}) column->set(to, (*column)[from]);
  for (auto* column : {&distance, &scattered}) (*column)[to] = (*column)[from];
  total[to] = total[from];
  radiance[to] = radiance[from];
}

/// Hidden lights stop no rays, so a ray may meet several, one a round.
void ScatterStage::add(const VertexQueue& vertices, Dimension dimension, std::uint32_t k, LightStage& lights,
                       const ConnectionQueue& samples, std::span<Rgb> radiance) {
  start(vertices, dimension, k, samples);
  while (!rays_.vertex.empty()) {
    for_each_packet(rays_.vertex.size(),
                    [&](std::size_t first, unsigned lanes) { find_lights(vertices, first, lanes); });
    drop_lost();
    weigh(lights, radiance);
  }
}

void ScatterStage::start(const VertexQueue& vertices, Dimension dimension, std::uint32_t k,
                         const ConnectionQueue& samples) {
  const std::size_t n = vertices.size();
  rays_.resize(k * n);
  for_each_packet(k * n, [&](std::size_t first, unsigned lanes) {
    for (std::size_t ray = first; ray < first + lanes; ++ray) {
      const std::size_t i = ray % n;
      const auto j = static_cast<std::uint32_t>(ray / n);
      const V3f axis = vertices.axis[i];
      const V3f direction =
          vertices.scattering.sample(axis, stage_.variate(dimension, vertices.path[i], vertices.sequence[i] + j));
      rays_.vertex[ray] = static_cast<std::uint32_t>(i);
      rays_.placed[ray] = vertices.light[i];
      rays_.position.set(ray, vertices.position[i]);
      rays_.direction.set(ray, direction);
      rays_.scattered[ray] = vertices.scattering.density(direction.dot(axis));
      rays_.distance[ray] = rays_.scattered[ray] > 0 ? 0 : lost;
      rays_.total[ray] = samples.total.empty() ? 0 : samples.total[i];
    }
  });
  drop_lost();
}

/// The next light of each ray, unless something is in the way.
void ScatterStage::find_lights(const VertexQueue& vertices, std::size_t first, unsigned lanes) {
  alignas(64) int valid[packet] = {};
  RTCRayHit16 rays = {};
  RTCRay16 shadow_rays = {};
  for (unsigned lane = 0; lane < lanes; ++lane) {
    const std::size_t ray = first + lane;
    valid[lane] = -1;
    for (RTCRay16* some : {&rays.ray, &shadow_rays}) {
      set_origin(*some, lane, vertices.ray_origin[rays_.vertex[ray]]);
      set_direction(*some, lane, rays_.direction[ray], std::numeric_limits<float>::infinity());
    }
    rays.ray.tnear[lane] = rays_.distance[ray] * just_behind;
    expect_hit(rays.hit, lane);
  }
  stage_.tracer.intersect_lights(valid, rays);
  for (unsigned lane = 0; lane < lanes; ++lane) {
    const std::size_t ray = first + lane;
    rays_.distance[ray] = lost;
    valid[lane] = take_light(rays, lane, ray) ? -1 : 0;
    shadow_rays.tfar[lane] = rays.ray.tfar[lane] * just_before_the_light;
  }
  stage_.tracer.occluded(valid, shadow_rays);
  for (unsigned lane = 0; lane < lanes; ++lane)
    if (valid[lane] && shadow_rays.tfar[lane] < 0) rays_.distance[first + lane] = lost;
}

/// False if there is none. One that brings nothing, from behind say, is taken with a radiance of zero.
bool ScatterStage::take_light(const RTCRayHit16& hits, unsigned lane, std::size_t ray) {
  const Shape* const shape = stage_.tracer.shape_of(hits, lane);
  if (!shape) return false;
  rays_.distance[ray] = hits.ray.tfar[lane];
  const auto light = stage_.lights.find(*shape->emitter, hits.hit.primID[lane]);
  rays_.light[ray] = light.value_or(0);
  rays_.radiance[ray] = Rgb(0.0f);
  if (!light || (rays_.placed[ray] != any_light && rays_.placed[ray] != *light)) return true;
  const LightFacts& facts = stage_.lights[*light];
  if (facts.double_sided || facts.normal.dot(rays_.direction[ray]) < 0) rays_.radiance[ray] = facts.radiance;
  return true;
}

void ScatterStage::drop_lost() {
  std::size_t end = 0;
  for (std::size_t ray = 0; ray < rays_.vertex.size(); ++ray) {
    if (rays_.distance[ray] == lost) continue;
    if (end != ray) rays_.copy(ray, end);
    ++end;
  }
  rays_.resize(end);
}

void ScatterStage::weigh(LightStage& lights, std::span<Rgb> radiance) {
  const bool mis = stage_.settings.strategy == Strategy::mis;
  const std::size_t n = rays_.vertex.size();
  density_.assign(n, 0);
  if (mis && n > 0)
    lights.density(rays_.position.points(), rays_.direction.directions(), rays_.light, rays_.total, rays_.placed,
                   density_);
  for (std::size_t ray = 0; ray < n; ++ray) {
    const float weight = rays_.scattered[ray] / (rays_.scattered[ray] + density_[ray]);
    radiance[rays_.vertex[ray]] +=
        rays_.radiance[ray] * weight *
        transmittance(stage_.scene.medium, rays_.position[ray], rays_.direction[ray], rays_.distance[ray]);
  }
}

}  // namespace wavefront
