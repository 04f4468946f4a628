// Camera rays: the surfaces they meet, the parts of them that lie in the medium, and the lights that they see.
#pragma once

#include "camera.h"
#include "film.h"
#include "stage.h"

namespace wavefront {

class CameraStage {
 public:
  /// Blocks of so many pixels are traced in parallel.
  CameraStage(const Stage& stage, std::size_t pixels_per_block);

  /// Traces the rays of a chunk of so many blocks. Light that is seen directly goes to the image at once; `rays` stays
  /// empty where there is no medium.
  void trace(std::size_t blocks, VertexQueue& surfaces, RayQueue& rays, Image& image) const;

 private:
  struct Output {
    std::size_t block;
    VertexQueue& surfaces;
    RayQueue& rays;
    Image& image;
  };
  V3f direction_of(std::size_t path, const Image& image) const;
  void trace_packet(std::size_t first_path, unsigned lanes, const Output& out) const;
  void take(const SurfacePoint& point, std::size_t path, const Rgb& through, const Output& out) const;
  Rgb cross_medium(std::size_t path, const V3f& direction, float end, const Output& out) const;

  const Stage& stage_;
  const Camera camera_;
  const Sampler sampler_;
  const std::size_t pixels_per_block_;
};

}  // namespace wavefront
