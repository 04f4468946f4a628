#include "wavefront.h"

#include "camera.h"
#include "progress.h"
#include "queues.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace wavefront {
namespace {

using Clock = std::chrono::steady_clock;

constexpr unsigned packet = 16;
constexpr std::size_t lanes_per_block = 4096;          // a block is one task of the camera and film stages …
constexpr std::size_t blocks_per_chunk = 32;           // … and a chunk fills the queues once: about 10 MB
constexpr float just_before_the_light = 1 - 0x1p-13f;  // so that a visible light does not shadow itself

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

struct Block {
  std::size_t first_hit, hits;
};

std::size_t pixels_per_block(const RenderSettings& settings) {
  if (settings.width < 1 || settings.height < 1) throw std::invalid_argument("the picture has no pixels");
  const std::size_t lanes_per_pixel = std::size_t{settings.spp} * settings.light_samples;
  if (lanes_per_pixel == 0) throw std::invalid_argument("a pixel needs at least one sample");
  return std::max<std::size_t>(1, lanes_per_block / lanes_per_pixel);
}

class Renderer {
 public:
  Renderer(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings);
  Render run(const std::string& label);

 private:
  std::size_t pixels_in(std::size_t block) const;
  std::size_t paths_before(std::size_t block) const { return block * pixels_per_block_ * settings_.spp; }

  V3f camera_direction(std::size_t path) const;
  void trace_camera_rays(std::size_t block);
  void trace_camera_packet(std::size_t first_path, unsigned lanes, Block& block);
  void take_hit(const SurfacePoint& point, std::size_t path, Block& block);
  void queue_hit(const SurfacePoint& point, std::size_t path, Block& block);
  void close_gaps();
  void draw_variates(std::size_t emitter, std::size_t begin, std::size_t end);
  void sample_light(const Emitter& emitter);
  void trace_shadow_rays(const Emitter& emitter, std::size_t first, unsigned lanes);
  void add_to_film(std::size_t block);
  void light_hits();

  std::size_t pixel_of(std::size_t path) const { return first_pixel_ + path / settings_.spp; }

  const Scene& scene_;
  const RayTracer& tracer_;
  const RenderSettings settings_;
  const Camera camera_;
  const Sampler camera_sampler_;
  const Sampler light_sampler_;
  const std::size_t pixels_per_block_;

  std::size_t first_pixel_ = 0;  // of the chunk
  std::vector<Block> blocks_;
  HitQueue hits_;
  LightQueue light_;
  std::vector<Rgb> irradiance_;  // of the hits, times light_samples
  Render result_;
};

Renderer::Renderer(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings)
    : scene_(scene),
      tracer_(tracer),
      settings_(settings),
      camera_(scene.view, settings.width, settings.height),
      camera_sampler_(settings.sampler, std::bit_ceil(settings.spp)),
      light_sampler_(settings.sampler, settings.spp * settings.light_samples),
      pixels_per_block_(pixels_per_block(settings)),
      blocks_(blocks_per_chunk),
      result_{Image(settings.width, settings.height)} {
  check_suits(settings.sampling, scene);
}

Render Renderer::run(const std::string& label) {
  const auto start = Clock::now();
  const std::size_t pixels = result_.image.pixels.size();
  Progress progress(label, pixels);
  for (first_pixel_ = 0; first_pixel_ < pixels; first_pixel_ += blocks_per_chunk * pixels_per_block_) {
    hits_.resize(paths_before(blocks_per_chunk));
    tbb::parallel_for(std::size_t{0}, blocks_per_chunk, [&](std::size_t block) { trace_camera_rays(block); });
    close_gaps();
    light_hits();
    tbb::parallel_for(std::size_t{0}, blocks_per_chunk, [&](std::size_t block) { add_to_film(block); });
    progress.advance(std::min(blocks_per_chunk * pixels_per_block_, pixels - first_pixel_));
  }
  result_.seconds = seconds_since(start);
  return std::move(result_);
}

std::size_t Renderer::pixels_in(std::size_t block) const {
  const std::size_t first = std::min(first_pixel_ + block * pixels_per_block_, result_.image.pixels.size());
  return std::min(pixels_per_block_, result_.image.pixels.size() - first);
}

void Renderer::trace_camera_rays(std::size_t block) {
  const std::size_t begin = paths_before(block);
  const std::size_t end = begin + pixels_in(block) * settings_.spp;
  blocks_[block] = {begin, 0};
  for (std::size_t path = begin; path < end; path += packet)
    trace_camera_packet(path, static_cast<unsigned>(std::min<std::size_t>(packet, end - path)), blocks_[block]);
}

V3f Renderer::camera_direction(std::size_t path) const {
  constexpr std::uint64_t camera_seed = 0x63616d657261;  // no setting enters: see RenderSettings
  const std::size_t pixel = pixel_of(path);
  const std::size_t column = pixel % static_cast<std::size_t>(settings_.width);
  const std::size_t row = pixel / static_cast<std::size_t>(settings_.width);
  const std::uint64_t key = hash(camera_seed, pixel);
  // Shuffled, or the sample of the light would be a function of the place in the pixel.
  const auto index_bits = static_cast<int>(std::bit_width(settings_.spp - 1));
  const auto index = shuffle_index(static_cast<std::uint32_t>(path % settings_.spp), index_bits, ~key);
  const Sample2 place = camera_sampler_(key, index);
  return camera_.direction(static_cast<float>(column) + place.x, static_cast<float>(row) + place.y);
}

void Renderer::trace_camera_packet(std::size_t first_path, unsigned lanes, Block& block) {
  alignas(64) int valid[packet] = {};
  RTCRayHit16 rays = {};
  for (unsigned lane = 0; lane < lanes; ++lane) {
    const V3f direction = camera_direction(first_path + lane);
    valid[lane] = -1;
    rays.ray.org_x[lane] = camera_.origin().x;
    rays.ray.org_y[lane] = camera_.origin().y;
    rays.ray.org_z[lane] = camera_.origin().z;
    rays.ray.dir_x[lane] = direction.x;
    rays.ray.dir_y[lane] = direction.y;
    rays.ray.dir_z[lane] = direction.z;
    rays.ray.tfar[lane] = std::numeric_limits<float>::infinity();
    rays.ray.mask[lane] = ~0u;
    rays.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
  }
  tracer_.intersect(valid, rays);
  for (unsigned lane = 0; lane < lanes; ++lane)
    if (const auto point = tracer_.surface(rays, lane)) take_hit(*point, first_path + lane, block);
}

void Renderer::take_hit(const SurfacePoint& point, std::size_t path, Block& block) {
  if (point.shape->emitter) {
    const Emitter& emitter = scene_.emitters[*point.shape->emitter];
    if (point.front || emitter.double_sided)
      result_.image.pixels[pixel_of(path)] += emitter.radiance / static_cast<float>(settings_.spp);
  }
  if (point.outside) queue_hit(point, path, block);
}

void Renderer::queue_hit(const SurfacePoint& point, std::size_t path, Block& block) {
  const std::size_t i = block.first_hit + block.hits++;
  hits_.x[i] = point.position.x;
  hits_.y[i] = point.position.y;
  hits_.z[i] = point.position.z;
  hits_.normal_x[i] = point.normal.x;
  hits_.normal_y[i] = point.normal.y;
  hits_.normal_z[i] = point.normal.z;
  hits_.origin_x[i] = point.shadow_origin.x;
  hits_.origin_y[i] = point.shadow_origin.y;
  hits_.origin_z[i] = point.shadow_origin.z;
  hits_.path[i] = static_cast<std::uint32_t>(path);
  hits_.shape[i] = point.shape;
}

/// Each block has queued its hits where its paths begin; now they move together. Most scenes fill the picture, so there
/// is little to move and no use in doing it in parallel.
void Renderer::close_gaps() {
  std::size_t end = 0;
  for (Block& block : blocks_) {
    if (block.first_hit != end) hits_.move(block.first_hit, end, block.hits);
    block.first_hit = end;
    end += block.hits;
  }
  hits_.resize(end);
}

void Renderer::light_hits() {
  const std::size_t n = hits_.size();
  irradiance_.assign(n, Rgb(0.0f));
  light_.resize(n * settings_.light_samples);
  if (n == 0) return;
  for (std::size_t emitter = 0; emitter < scene_.emitters.size(); ++emitter) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, packet),
                      [&](const auto& range) { draw_variates(emitter, range.begin(), range.end()); });
    sample_light(scene_.emitters[emitter]);
    tbb::parallel_for(std::size_t{0}, (n + packet - 1) / packet, [&](std::size_t i) {
      const std::size_t first = i * packet;
      trace_shadow_rays(scene_.emitters[emitter], first,
                        static_cast<unsigned>(std::min<std::size_t>(packet, n - first)));
    });
  }
}

/// The k samples of a hit are k consecutive points of its pixel's sequence: a net by themselves, and together with
/// those of the pixel's other hits.
void Renderer::draw_variates(std::size_t emitter, std::size_t begin, std::size_t end) {
  const std::size_t n = hits_.size();
  const std::uint64_t seed = hash(settings_.seed, emitter);
  for (std::size_t i = begin; i < end; ++i) {
    const std::uint64_t key = hash(seed, pixel_of(hits_.path[i]));
    const std::uint32_t first = hits_.path[i] % settings_.spp * settings_.light_samples;
    for (std::uint32_t j = 0; j < settings_.light_samples; ++j) {
      const Sample2 sample = light_sampler_(key, first + j);
      light_.u[j * n + i] = sample.x;
      light_.v[j * n + i] = sample.y;
    }
  }
}

void Renderer::sample_light(const Emitter& emitter) {
  const hatbox::Points points{hits_.x, hits_.y, hits_.z};
  const hatbox::Variates variates{light_.u, light_.v};
  hatbox::Samples samples{light_.x, light_.y, light_.z, light_.distance, light_.pdf};
  if (!emitter.double_sided) samples.cosine = light_.cosine;
  const auto start = Clock::now();
  settings_.sampling.sample(emitter.light, points, variates, samples);
  result_.light_seconds += seconds_since(start);
  result_.light_samples += light_.u.size();
}

void Renderer::trace_shadow_rays(const Emitter& emitter, std::size_t first, unsigned lanes) {
  const std::size_t n = hits_.size();
  alignas(64) int valid[packet] = {};
  float weight[packet];
  float sum[packet] = {};
  RTCRay16 rays = {};
  for (unsigned lane = 0; lane < lanes; ++lane) {
    rays.org_x[lane] = hits_.origin_x[first + lane];
    rays.org_y[lane] = hits_.origin_y[first + lane];
    rays.org_z[lane] = hits_.origin_z[first + lane];
    rays.mask[lane] = ~0u;
  }
  for (std::size_t j = 0; j < settings_.light_samples; ++j) {
    bool any = false;
    for (unsigned lane = 0; lane < lanes; ++lane) {
      const std::size_t i = first + lane;
      const std::size_t sample = j * n + i;
      rays.dir_x[lane] = light_.x[sample];
      rays.dir_y[lane] = light_.y[sample];
      rays.dir_z[lane] = light_.z[sample];
      rays.tfar[lane] = light_.distance[sample] * just_before_the_light;
      const float cosine = rays.dir_x[lane] * hits_.normal_x[i] + rays.dir_y[lane] * hits_.normal_y[i] +
                           rays.dir_z[lane] * hits_.normal_z[i];
      const bool lit = light_.pdf[sample] > 0 && cosine > 0 && (emitter.double_sided || light_.cosine[sample] > 0);
      valid[lane] = lit ? -1 : 0;
      weight[lane] = lit ? cosine / light_.pdf[sample] : 0;
      any |= lit;
    }
    if (!any) continue;
    tracer_.occluded(valid, rays);
    for (unsigned lane = 0; lane < lanes; ++lane) sum[lane] += rays.tfar[lane] >= 0 ? weight[lane] : 0;
  }
  for (unsigned lane = 0; lane < lanes; ++lane) irradiance_[first + lane] += emitter.radiance * sum[lane];
}

void Renderer::add_to_film(std::size_t block) {
  const float scale =
      std::numbers::inv_pi_v<float> / (static_cast<float>(settings_.spp) * static_cast<float>(settings_.light_samples));
  const Block& hits = blocks_[block];
  for (std::size_t i = hits.first_hit; i < hits.first_hit + hits.hits; ++i)
    result_.image.pixels[pixel_of(hits_.path[i])] += hits_.shape[i]->reflectance * irradiance_[i] * scale;
}

}  // namespace

Render render(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings, const std::string& label) {
  return Renderer(scene, tracer, settings).run(label);
}

}  // namespace wavefront
