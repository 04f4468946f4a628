#include "medium_stage.h"

#include "medium.h"
#include "parallel.h"
#include "ray_weights.h"

#include <tbb/parallel_for.h>

#include <cmath>

namespace wavefront {

MediumStage::MediumStage(const Stage& stage) : stage_(stage), count_(stage.settings.medium_samples()) {}

void MediumStage::place(const RayQueue& rays, const LightChoice& choice, VertexQueue& vertices,
                        ConnectionQueue& samples) {
  vertices.scattering = {.surface = false, .g = stage_.scene.medium->g};
  std::size_t most = 0;
  for (const Range& block : rays.blocks) most = std::max(most, block.count);
  vertices.open(rays.blocks.size(), most * count_);
  if (stage_.settings.media_used() == Media::march) {
    march(rays, vertices);
  } else {
    repeat(rays);
    choose_lights(choice);
    choose_distances();
    add_chosen(rays, vertices);
  }
  vertices.close();
  if (stage_.settings.media_used() == Media::area_first) connect(vertices, samples);
}

void MediumStage::add(const Place& place, std::size_t block, VertexQueue& vertices) const {
  const std::size_t i = vertices.add(block);
  vertices.position.set(i, place.position);
  vertices.axis.set(i, place.direction);
  vertices.ray_origin.set(i, place.position);
  vertices.throughput[i] = place.throughput;
  vertices.path[i] = place.path;
  vertices.sequence[i] = sequence(place.path, place.index);
  vertices.light[i] = place.light;
}

/// Steps that are equally long would hardly meet what matters of a ray that leaves for the horizon: these divide what
/// the ray loses in the channel that reaches farthest, so that no weight grows along it.
void MediumStage::march(const RayQueue& rays, VertexQueue& vertices) const {
  const float sigma = lowest_extinction(*stage_.scene.medium);
  tbb::parallel_for(std::size_t{0}, rays.blocks.size(), [&](std::size_t block) {
    const Range range = rays.blocks[block];
    for (std::size_t ray = range.first; ray < range.first + range.count; ++ray) {
      const V3f direction = rays.direction[ray];
      const float length = rays.end[ray] - rays.begin[ray];
      const float loss = -std::expm1(-sigma * length);
      for (std::uint32_t j = 0; j < count_; ++j) {
        const Sample2 sample = stage_.variate(Dimension::distance, rays.path[ray], sequence(rays.path[ray], j));
        const float u = (static_cast<float>(j) + sample.x) / static_cast<float>(count_);
        const float x = loss > 0 ? std::min(-std::log1p(-u * loss) / sigma, length) : u * length;
        add({rays.origin[ray] + direction * (rays.begin[ray] + x), direction, step_weight(x, loss, length),
             rays.path[ray], j, any_light},
            block, vertices);
      }
    }
  });
}

/// Of a place `x` into the medium: its scattering and what comes from there to the camera, over the density of a march,
/// which goes like the transmittance itself.
Rgb MediumStage::step_weight(float x, float loss, float length) const {
  const Medium& medium = *stage_.scene.medium;
  const float sigma = lowest_extinction(medium);
  const Rgb rest = medium.sigma_s + medium.sigma_a - Rgb(sigma);
  const Rgb through(std::exp(-rest.x * x), std::exp(-rest.y * x), std::exp(-rest.z * x));
  return medium.sigma_s * through * ((loss > 0 ? loss / sigma : length) / static_cast<float>(stage_.settings.steps));
}

void MediumStage::repeat(const RayQueue& rays) {
  const std::size_t n = rays.size() * count_;
  slots_.for_each_column([n](auto& column) { column.resize(n); });
  u_.resize(n);
  chosen_.resize(n, 1);
  in_parallel(n, [&](std::size_t slot) {
    const std::size_t ray = slot / count_;
    slots_.origin.set(slot, rays.origin[ray]);
    slots_.direction.set(slot, rays.direction[ray]);
    slots_.begin[slot] = rays.begin[ray];
    slots_.end[slot] = rays.end[ray];
    slots_.path[slot] = rays.path[ray];
    const std::uint32_t index = sequence(rays.path[ray], static_cast<std::uint32_t>(slot % count_));
    const Sample2 sample = stage_.variate(Dimension::distance, rays.path[ray], index);
    u_[slot] = sample.x;
    chosen_.u[slot] = sample.y;
  });
}

void MediumStage::choose_lights(const LightChoice& choice) {
  RayWeights weights(stage_.lights, slots_);
  choice.choose(u_.size(), std::ref(weights), chosen_);
}

/// What the distance is equiangular about.
V3f MediumStage::pivot(const LightFacts& light, std::size_t path, std::uint32_t sequence) const {
  if (stage_.settings.media_used() == Media::equiangular) return light.centre;
  return light.place(stage_.variate(Dimension::medium_light, path, sequence));
}

void MediumStage::choose_distances() {
  const std::size_t n = u_.size();
  for (auto* columns : {&pivots_, &normals_}) columns->resize(n);
  for (auto* column : {&lit_begin_, &lit_end_, &distance_, &pdf_}) column->resize(n);
  in_parallel(n, [&](std::size_t slot) {
    const LightFacts& light = stage_.lights[chosen_.light[slot]];
    const auto index = sequence(slots_.path[slot], static_cast<std::uint32_t>(slot % count_));
    pivots_.set(slot, pivot(light, slots_.path[slot], index));
    normals_.set(slot, light.normal);
  });
  hatbox::parallel::equiangular::clip(slots_.segments(), pivots_.points(), normals_.directions(), lit_begin_, lit_end_);
  in_parallel(n, [&](std::size_t slot) {
    if (!stage_.lights[chosen_.light[slot]].double_sided) return;
    lit_begin_[slot] = slots_.begin[slot];
    lit_end_[slot] = slots_.end[slot];
  });
  hatbox::Segments lit = slots_.segments();
  lit.t_min = lit_begin_;
  lit.t_max = lit_end_;
  hatbox::parallel::equiangular::sample(lit, pivots_.points(), u_, distance_, pdf_);
}

void MediumStage::add_chosen(const RayQueue& rays, VertexQueue& vertices) const {
  const Medium& medium = *stage_.scene.medium;
  tbb::parallel_for(std::size_t{0}, rays.blocks.size(), [&](std::size_t block) {
    const Range range = rays.blocks[block];
    for (std::size_t slot = range.first * count_; slot < (range.first + range.count) * count_; ++slot) {
      const float density = pdf_[slot] * chosen_.probability[slot];
      if (!(density > 0) || !(lit_begin_[slot] < lit_end_[slot])) continue;
      const V3f direction = slots_.direction[slot];
      const Rgb throughput = medium.sigma_s * transmittance(medium, distance_[slot] - slots_.begin[slot]) / density;
      add({slots_.origin[slot] + direction * distance_[slot], direction, throughput, slots_.path[slot],
           static_cast<std::uint32_t>(slot % count_), chosen_.light[slot]},
          block, vertices);
    }
  });
}

/// The places on the lights that the distances were equiangular about become samples of the lights.
void MediumStage::connect(const VertexQueue& vertices, ConnectionQueue& samples) const {
  samples.resize(vertices.size(), 1);
  in_parallel(vertices.size(), [&](std::size_t i) {
    const LightFacts& light = stage_.lights[vertices.light[i]];
    const V3f way = pivot(light, vertices.path[i], vertices.sequence[i]) - vertices.position[i];
    const float distance = way.length();
    const V3f direction = distance > 0 ? way / distance : V3f(0);
    const float cosine = -direction.dot(light.normal);
    samples.light[i] = vertices.light[i];
    samples.probability[i] = 1;
    samples.direction.set(i, direction);
    samples.distance[i] = distance;
    samples.cosine[i] = cosine;
    samples.pdf[i] = cosine != 0 ? distance * distance / (light.area * std::abs(cosine)) : 0;
  });
}

}  // namespace wavefront
