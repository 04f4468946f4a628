#include "bounce_stage.h"

#include "parallel.h"

#include <limits>

namespace wavefront {

void BounceStage::trace(const VertexQueue& vertices, std::uint32_t bounce, VertexQueue& next) const {
  std::size_t largest = 0;
  for (const Range& range : vertices.blocks) largest = std::max(largest, range.count);
  next.scattering = vertices.scattering;
  next.open(vertices.blocks.size(), largest);
  tbb::parallel_for(std::size_t{0}, vertices.blocks.size(), [&](std::size_t block) {
    const auto [first, count] = vertices.blocks[block];
    for (std::size_t done = 0; done < count; done += packet)
      trace_packet(vertices, bounce, block, {first + done, std::min<std::size_t>(packet, count - done)}, next);
  });
  next.close();
}

void BounceStage::trace_packet(const VertexQueue& vertices, std::uint32_t bounce, std::size_t block, Range range,
                               VertexQueue& next) const {
  alignas(64) int valid[packet] = {};
  RTCRayHit16 rays = {};
  for (unsigned lane = 0; lane < range.count; ++lane) {
    const std::size_t i = range.first + lane;
    const V3f direction = vertices.scattering.sample(vertices.axis[i], stage_.bounce_variate(bounce, vertices.path[i]));
    valid[lane] = -1;
    set_origin(rays.ray, lane, vertices.ray_origin[i]);
    set_direction(rays.ray, lane, direction, std::numeric_limits<float>::infinity());
    expect_hit(rays.hit, lane);
  }
  stage_.tracer.intersect(valid, rays);
  for (unsigned lane = 0; lane < range.count; ++lane) {
    const auto point = stage_.tracer.surface(rays, lane);
    if (!point || !point->outside) continue;
    const std::size_t from = range.first + lane;
    add_surface(*point, vertices.throughput[from], vertices.path[from], vertices.sequence[from], block, next);
  }
}

}  // namespace wavefront
