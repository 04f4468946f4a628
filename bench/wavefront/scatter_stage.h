// Scattering rays: the direct light of a queue of vertices, from directions that the surface or the medium would
// choose, followed to the lights they happen to meet.
#pragma once

#include "light_stage.h"

namespace wavefront {

class ScatterStage {
 public:
  explicit ScatterStage(const Stage& stage) : stage_(stage) {}

  /// Adds what k directions a vertex bring, times k. With Strategy::mis weighed against the samples of `lights`, which
  /// were the last it took and are for these vertices.
  void add(const VertexQueue& vertices, Dimension dimension, std::uint32_t k, LightStage& lights,
           const ConnectionQueue& samples, std::span<Rgb> radiance);

 private:
  /// Rays on their way, and the light each meets next.
  struct Rays {
    std::vector<std::uint32_t> vertex, light, placed;
    VectorColumns position, direction;
    std::vector<float> distance, scattered;  // the density with which the direction was taken
    std::vector<double> total;
    std::vector<Rgb> radiance;

    void resize(std::size_t n);
    void copy(std::size_t from, std::size_t to);
  };

  void start(const VertexQueue& vertices, Dimension dimension, std::uint32_t k, const ConnectionQueue& samples);
  void find_lights(const VertexQueue& vertices, std::size_t first, unsigned lanes);
  bool take_light(const RTCRayHit16& hits, unsigned lane, std::size_t ray);
  void drop_lost();
  void weigh(LightStage& lights, std::span<Rgb> radiance);

  const Stage& stage_;
  Rays rays_;
  std::vector<float> density_;
};

}  // namespace wavefront
