#include "camera_stage.h"

#include "medium.h"
#include "parallel.h"

#include <bit>
#include <limits>

namespace wavefront {

CameraStage::CameraStage(const Stage& stage, std::size_t pixels_per_block)
    : stage_(stage),
      camera_(stage.scene.view, stage.settings.width, stage.settings.height),
      sampler_(stage.settings.sampler, std::bit_ceil(stage.settings.spp)),
      pixels_per_block_(pixels_per_block) {}

void CameraStage::trace(std::size_t blocks, VertexQueue& surfaces, RayQueue& rays, Image& image) const {
  const std::size_t paths_per_block = pixels_per_block_ * stage_.settings.spp;
  surfaces.scattering = {.surface = true};
  surfaces.open(blocks, paths_per_block);
  rays.open(blocks, stage_.scene.medium ? paths_per_block : 0);
  const std::size_t pixels = image.pixels.size();
  tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t block) {
    const std::size_t first_pixel = std::min(stage_.first_pixel + block * pixels_per_block_, pixels);
    const std::size_t begin = block * paths_per_block;
    const std::size_t end = begin + std::min(pixels_per_block_, pixels - first_pixel) * stage_.settings.spp;
    for (std::size_t path = begin; path < end; path += packet)
      trace_packet(path, static_cast<unsigned>(std::min<std::size_t>(packet, end - path)),
                   {block, surfaces, rays, image});
  });
  surfaces.close();
  rays.close();
}

V3f CameraStage::direction_of(std::size_t path, const Image& image) const {
  constexpr std::uint64_t camera_seed = 0x63616d657261;  // no setting enters: see RenderSettings
  const std::uint32_t spp = stage_.settings.spp;
  const std::size_t pixel = stage_.pixel_of(path);
  const std::size_t column = pixel % static_cast<std::size_t>(image.width);
  const std::size_t row = pixel / static_cast<std::size_t>(image.width);
  const std::uint64_t key = hash(camera_seed, pixel);
  // Shuffled, or the sample of the light would be a function of the place in the pixel.
  const auto index_bits = static_cast<int>(std::bit_width(spp - 1));
  const auto index = shuffle_index(static_cast<std::uint32_t>(path % spp), index_bits, ~key);
  const Sample2 place = sampler_(key, index);
  return camera_.direction(static_cast<float>(column) + place.x, static_cast<float>(row) + place.y);
}

void CameraStage::trace_packet(std::size_t first_path, unsigned lanes, const Output& out) const {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  alignas(64) int valid[packet] = {};
  V3f directions[packet];
  RTCRayHit16 rays = {};
  for (unsigned lane = 0; lane < lanes; ++lane) {
    directions[lane] = direction_of(first_path + lane, out.image);
    valid[lane] = -1;
    set_origin(rays.ray, lane, camera_.origin());
    set_direction(rays.ray, lane, directions[lane], infinity);
    expect_hit(rays.hit, lane);
  }
  stage_.tracer.intersect(valid, rays);
  for (unsigned lane = 0; lane < lanes; ++lane) {
    const auto point = stage_.tracer.surface(rays, lane);
    const Rgb through = cross_medium(first_path + lane, directions[lane], rays.ray.tfar[lane], out);
    if (point) take(*point, first_path + lane, through, out);
  }
}

/// Queues the part of a ray that lies in the medium, and tells what gets through it.
Rgb CameraStage::cross_medium(std::size_t path, const V3f& direction, float end, const Output& out) const {
  if (!stage_.scene.medium) return Rgb(1.0f);
  const Interval part = inside(*stage_.scene.medium, camera_.origin(), direction, end);
  if (!(part.begin < part.end)) return Rgb(1.0f);
  const std::size_t i = out.rays.add(out.block);
  out.rays.origin.set(i, camera_.origin());
  out.rays.direction.set(i, direction);
  out.rays.begin[i] = part.begin;
  out.rays.end[i] = part.end;
  out.rays.path[i] = static_cast<std::uint32_t>(path);
  return transmittance(*stage_.scene.medium, part.end - part.begin);
}

void CameraStage::take(const SurfacePoint& point, std::size_t path, const Rgb& through, const Output& out) const {
  if (point.shape->emitter) {
    const Emitter& emitter = stage_.scene.emitters[*point.shape->emitter];
    if (point.front || emitter.double_sided)
      out.image.pixels[stage_.pixel_of(path)] += emitter.radiance * through / static_cast<float>(stage_.settings.spp);
  }
  const std::uint32_t sequence = static_cast<std::uint32_t>(path % stage_.settings.spp) * stage_.settings.light_samples;
  if (point.outside) add_surface(point, through, path, sequence, out.block, out.surfaces);
}

}  // namespace wavefront
