// Light choice, light sampling (by the library) and shadow rays: the direct light of a queue of vertices, from samples
// of the lights.
#pragma once

#include "light_choice.h"
#include "stage.h"

namespace wavefront {

class LightStage {
 public:
  explicit LightStage(const Stage& stage);

  /// Chooses lights for k samples a vertex and samples them. A vertex that is for one light only gets that one.
  void sample(const VertexQueue& vertices, Dimension dimension, std::uint32_t k, ConnectionQueue& samples);

  /// Adds what the samples bring to each vertex, times k: radiance over density, as far as it is seen.
  void trace_shadow_rays(const VertexQueue& vertices, const ConnectionQueue& samples, std::span<Rgb> radiance) const;

  /// The density with which `sample` takes each direction to each light, choice included, after it was called for these
  /// vertices. `total` is ConnectionQueue::total of each.
  void density(hatbox::Points points, hatbox::Directions directions, std::span<const std::uint32_t> light,
               std::span<const double> total, std::span<const std::uint32_t> placed, std::span<float> out);

  const LightChoice& choice() const { return choice_; }

  std::uint64_t samples_taken = 0;
  double seconds = 0;  // for choosing and sampling

 private:
  void draw(const VertexQueue& vertices, Dimension dimension, std::uint32_t k, ConnectionQueue& samples) const;
  void choose(const VertexQueue& vertices, ConnectionQueue& samples) const;
  void sample_chosen(const VertexQueue& vertices, std::uint32_t k, ConnectionQueue& samples);
  void trace_packet(const VertexQueue& vertices, const ConnectionQueue& samples, std::size_t first, unsigned lanes,
                    std::span<Rgb> radiance) const;

  const Stage& stage_;
  const LightChoice choice_;
  const hatbox::LightSet set_;
  hatbox::Workspace workspace_;
  VectorColumns repeated_;  // the vertices, once for each sample
  std::vector<float> solid_angles_;
};

}  // namespace wavefront
