#include "light_stage.h"

#include "medium.h"
#include "parallel.h"

#include <tbb/enumerable_thread_specific.h>

#include <chrono>

namespace wavefront {
namespace {

float weight_of(const LightFacts& light, const V3f& point, float solid_angle) {
  return light.shines_on(point) ? light.luminance * solid_angle : 0;
}

/// Solid angle × luminance, where the light shines at all; one light at a time from all points of a block.
class SolidAngleWeights {
 public:
  SolidAngleWeights(const LightTable& lights, const hatbox::LightSet& set, const VectorColumns& points)
      : lights_(lights), set_(set), points_(points) {}

  void operator()(std::uint32_t light, std::size_t begin, std::span<float> out) {
    Scratch& scratch = scratch_.local();
    scratch.light.assign(out.size(), light);
    const auto part = [&](const std::vector<float>& all) { return std::span(all).subspan(begin, out.size()); };
    hatbox::solid_angle(set_, scratch.light, {part(points_.x), part(points_.y), part(points_.z)}, out,
                        scratch.workspace);
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = weight_of(lights_[light], points_[begin + i], out[i]);
  }

 private:
  struct Scratch {
    std::vector<std::uint32_t> light;
    hatbox::Workspace workspace;
  };
  const LightTable& lights_;
  const hatbox::LightSet& set_;
  const VectorColumns& points_;
  tbb::enumerable_thread_specific<Scratch> scratch_;
};

}  // namespace

LightStage::LightStage(const Stage& stage)
    : stage_(stage),
      choice_(stage.lights, stage.settings.choice),
      set_(stage.lights.make_set(stage.settings.sampling.maps)) {}

void LightStage::sample(const VertexQueue& vertices, Dimension dimension, std::uint32_t k, ConnectionQueue& samples) {
  samples.resize(vertices.size(), k);
  if (samples.size() == 0) return;
  draw(vertices, dimension, k, samples);
  const auto start = std::chrono::steady_clock::now();
  choose(vertices, samples);
  sample_chosen(vertices, k, samples);
  seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  samples_taken += samples.size();
}

/// The k samples of a vertex are k consecutive points of its pixel's sequence: a net by themselves, and together with
/// those of the pixel's other vertices.
void LightStage::draw(const VertexQueue& vertices, Dimension dimension, std::uint32_t k,
                      ConnectionQueue& samples) const {
  const std::size_t n = vertices.size();
  in_parallel(n, [&](std::size_t i) {
    for (std::uint32_t j = 0; j < k; ++j) {
      const Sample2 sample = stage_.variate(dimension, vertices.path[i], vertices.sequence[i] + j);
      samples.u[j * n + i] = sample.x;
      samples.v[j * n + i] = sample.y;
    }
  });
}

void LightStage::choose(const VertexQueue& vertices, ConnectionQueue& samples) const {
  if (vertices.light.front() != any_light) {  // then all of the queue are for one light each
    for (std::size_t first = 0; first < samples.size(); first += vertices.size())
      std::copy(vertices.light.begin(), vertices.light.end(),
                samples.light.begin() + static_cast<std::ptrdiff_t>(first));
    std::fill(samples.probability.begin(), samples.probability.end(), 1.0f);
    return;
  }
  SolidAngleWeights weights(stage_.lights, set_, vertices.position);
  choice_.choose(vertices.size(), std::ref(weights), samples);
}

void LightStage::sample_chosen(const VertexQueue& vertices, std::uint32_t k, ConnectionQueue& samples) {
  const hatbox::Samples out{.x = samples.direction.x,
                            .y = samples.direction.y,
                            .z = samples.direction.z,
                            .distance = samples.distance,
                            .pdf = samples.pdf,
                            .cosine = samples.cosine};
  const hatbox::Variates variates{samples.u, samples.v};
  const hatbox::Points points = vertices.position.points();
  if (stage_.settings.sampling.sample_disk) {
    stage_.settings.sampling.sample_disk(std::get<hatbox::Disk>(stage_.scene.emitters[0].light), points, variates, out);
    return;
  }
  if (k == 1 || set_.size() == 1) {  // the samples of a vertex share its light, and hatbox its set-up
    hatbox::parallel::sample(set_, std::span(samples.light).first(vertices.size()), points, variates, out, workspace_);
    return;
  }
  repeated_.resize(samples.size());
  in_parallel(samples.size(), [&](std::size_t i) { repeated_.set(i, vertices.position[i % vertices.size()]); });
  hatbox::parallel::sample(set_, samples.light, repeated_.points(), variates, out, workspace_);
}

void LightStage::density(hatbox::Points points, hatbox::Directions directions, std::span<const std::uint32_t> light,
                         std::span<const double> total, std::span<const std::uint32_t> placed, std::span<float> out) {
  hatbox::parallel::pdf(set_, light, points, directions, out, workspace_);
  solid_angles_.assign(light.size(), 0);
  if (choice_.by_point()) hatbox::parallel::solid_angle(set_, light, points, solid_angles_, workspace_);
  in_parallel(light.size(), [&](std::size_t i) {
    if (placed[i] != any_light) return;
    const V3f point(points.x[i], points.y[i], points.z[i]);
    const float weight = weight_of(stage_.lights[light[i]], point, solid_angles_[i]);
    out[i] *= choice_.probability(light[i], weight, total[i]);
  });
}

void LightStage::trace_shadow_rays(const VertexQueue& vertices, const ConnectionQueue& samples,
                                   std::span<Rgb> radiance) const {
  for_each_packet(vertices.size(),
                  [&](std::size_t first, unsigned lanes) { trace_packet(vertices, samples, first, lanes, radiance); });
}

void LightStage::trace_packet(const VertexQueue& vertices, const ConnectionQueue& samples, std::size_t first,
                              unsigned lanes, std::span<Rgb> radiance) const {
  const std::size_t n = vertices.size();
  const bool mis = stage_.settings.strategy == Strategy::mis;
  alignas(64) int valid[packet] = {};
  float weight[packet];
  RTCRay16 rays = {};
  for (unsigned lane = 0; lane < lanes; ++lane) set_origin(rays, lane, vertices.ray_origin[first + lane]);
  for (std::size_t sample = first; sample < samples.size(); sample += n) {
    bool any = false;
    for (unsigned lane = 0; lane < lanes; ++lane) {
      const std::size_t i = sample + lane;
      const LightFacts& light = stage_.lights[samples.light[i]];
      const V3f direction = samples.direction[i];
      const float scattered = vertices.scattering.density(direction.dot(vertices.axis[first + lane]));
      const float density = samples.probability[i] * samples.pdf[i];
      const bool lit = density > 0 && scattered > 0 && (light.double_sided || samples.cosine[i] > 0);
      valid[lane] = lit ? -1 : 0;
      weight[lane] = lit ? scattered / (mis ? density + scattered : density) : 0;
      any |= lit;
      set_direction(rays, lane, direction, samples.distance[i] * just_before_the_light);
    }
    if (!any) continue;
    stage_.tracer.occluded(valid, rays);
    for (unsigned lane = 0; lane < lanes; ++lane) {
      const std::size_t i = sample + lane;
      if (!valid[lane] || rays.tfar[lane] < 0) continue;
      const Rgb through = transmittance(stage_.scene.medium, vertices.position[first + lane], samples.direction[i],
                                        samples.distance[i]);
      radiance[first + lane] += stage_.lights[samples.light[i]].radiance * through * weight[lane];
    }
  }
}

}  // namespace wavefront
