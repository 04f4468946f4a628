#include "wavefront.h"

#include "bounce_stage.h"
#include "camera_stage.h"
#include "light_stage.h"
#include "medium_stage.h"
#include "progress.h"
#include "scatter_stage.h"

#include <tbb/parallel_for.h>

#include <bit>
#include <chrono>
#include <stdexcept>

namespace wavefront {
namespace {

constexpr std::size_t lanes_per_block = 4096;                  // a block is one task of the camera and film stages …
constexpr std::size_t lanes_per_chunk = std::size_t{1} << 17;  // … and a chunk fills the queues once: about 20 MB

std::uint32_t samples_per_pixel(const Scene& scene, const RenderSettings& settings) {
  return std::max(1u, settings.spp * (scene.medium ? settings.medium_samples() : settings.light_samples));
}

class Renderer {
 public:
  Renderer(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings)
      : lights_(scene),
        settings_(settings),
        samples_per_pixel_(samples_per_pixel(scene, settings)),
        sampler_(settings.sampler, std::bit_ceil(samples_per_pixel_)),
        stage_{scene, tracer, lights_, settings_, sampler_, static_cast<int>(std::bit_width(samples_per_pixel_ - 1))},
        pixels_per_block_(std::max<std::size_t>(1, lanes_per_block / samples_per_pixel_)),
        blocks_per_chunk_(std::max<std::size_t>(1, lanes_per_chunk / (pixels_per_block_ * samples_per_pixel_))),
        camera_(stage_, pixels_per_block_),
        bounce_(stage_),
        medium_(stage_),
        light_(stage_),
        scatter_(stage_),
        result_{Image(settings.width, settings.height)} {}

  Render run(const std::string& label);

 private:
  void render_chunk();
  void gather(const VertexQueue& vertices, std::uint32_t k, std::uint32_t bounce = 0);
  void add_to_film(const VertexQueue& vertices);

  const LightTable lights_;
  const RenderSettings settings_;
  const std::uint32_t samples_per_pixel_;
  const Sampler sampler_;
  Stage stage_;
  const std::size_t pixels_per_block_, blocks_per_chunk_;
  const CameraStage camera_;
  const BounceStage bounce_;
  MediumStage medium_;
  LightStage light_;
  ScatterStage scatter_;

  RayQueue rays_;
  VertexQueue vertices_, bounced_, fog_vertices_;
  ConnectionQueue samples_;
  std::vector<Rgb> radiance_;  // of the vertices, times k
  Render result_;
};

Render Renderer::run(const std::string& label) {
  const auto start = std::chrono::steady_clock::now();
  const std::size_t pixels = result_.image.pixels.size();
  const std::size_t pixels_per_chunk = blocks_per_chunk_ * pixels_per_block_;
  Progress progress(label, pixels);
  for (; stage_.first_pixel < pixels; stage_.first_pixel += pixels_per_chunk) {
    render_chunk();
    progress.advance(std::min(pixels_per_chunk, pixels - stage_.first_pixel));
  }
  result_.light_samples = light_.samples_taken;
  result_.light_seconds = light_.seconds;
  result_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return std::move(result_);
}

void Renderer::render_chunk() {
  camera_.trace(blocks_per_chunk_, vertices_, rays_, result_.image);
  gather(vertices_, settings_.light_samples);
  for (std::uint32_t bounce = 1; bounce < settings_.depth; ++bounce) {
    bounce_.trace(vertices_, bounce, bounced_);
    std::swap(vertices_, bounced_);
    gather(vertices_, settings_.light_samples, bounce);
  }
  if (!stage_.scene.medium) return;
  medium_.place(rays_, light_.choice(), fog_vertices_, samples_);
  gather(fog_vertices_, 1);
}

void Renderer::gather(const VertexQueue& vertices, std::uint32_t k, std::uint32_t bounce) {
  const bool surface = vertices.scattering.surface;
  radiance_.assign(vertices.size(), Rgb(0.0f));
  if (settings_.samples_lights()) {
    const bool sampled = !surface && settings_.media_used() == Media::area_first;  // along with their places
    const Dimension dimension = surface ? Dimension::light : Dimension::medium_light;
    if (!sampled) light_.sample(vertices, after_bounce(dimension, bounce), k, samples_);
    light_.trace_shadow_rays(vertices, samples_, radiance_);
  }
  if (settings_.samples_scattering()) {
    const Dimension dimension = surface ? Dimension::scattering : Dimension::medium_scattering;
    scatter_.add(vertices, after_bounce(dimension, bounce), k, light_, samples_, radiance_);
  }
  add_to_film(vertices);
}

/// A path has one vertex on a surface, or as many in the medium as samples: k samples either way.
void Renderer::add_to_film(const VertexQueue& vertices) {
  const float scale = 1 / (static_cast<float>(settings_.spp) * static_cast<float>(settings_.light_samples));
  tbb::parallel_for(std::size_t{0}, vertices.blocks.size(), [&](std::size_t block) {
    const Range range = vertices.blocks[block];
    for (std::size_t i = range.first; i < range.first + range.count; ++i)
      result_.image.pixels[stage_.pixel_of(vertices.path[i])] += vertices.throughput[i] * radiance_[i] * scale;
  });
}

}  // namespace

void check(const Scene& scene, const RenderSettings& settings) {
  if (settings.width < 1 || settings.height < 1) throw std::invalid_argument("the picture has no pixels");
  if (settings.spp == 0 || settings.light_samples == 0)
    throw std::invalid_argument("a pixel needs at least one sample");
  if (settings.depth == 0) throw std::invalid_argument("a path needs a depth of at least 1");
  if (settings.depth > 1 && scene.medium)
    throw std::invalid_argument("a depth of more than 1 is for scenes without a medium");
  if (settings.steps == 0) throw std::invalid_argument("a march needs at least one step");
  if (settings.strategy == Strategy::mis && settings.sampling.sample_disk)
    throw std::invalid_argument("map '" + settings.sampling.name + "' tells no density of a direction: not for mis");
  if (scene.medium && settings.media_used() == Media::area_first && settings.strategy != Strategy::light)
    throw std::invalid_argument("area-first takes places on the light for places in the medium: strategy light only");
  check_suits(settings.sampling, scene);
}

Render render(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings, const std::string& label) {
  check(scene, settings);
  return Renderer(scene, tracer, settings).run(label);
}

}  // namespace wavefront
