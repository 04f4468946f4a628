// Medium sampling: places on camera rays at which the medium's single scattering gathers light.
//
//   equiangular  one light for each place, chosen for the ray; the distance equiangular about its centre (Kulla and
//                Fajardo 2012), light from it alone (Guillén et al. 2017, §5)
//   area_first   the same about a place on the light that was chosen before, uniformly in area; light from that place
//                alone (ibid., "area sampling (first)")
//   march        a fixed number of steps (Ureña et al. 2013, Figure 8), through equal parts of what the ray loses
#pragma once

#include "light_choice.h"
#include "stage.h"

namespace wavefront {

class MediumStage {
 public:
  explicit MediumStage(const Stage& stage);

  /// RenderSettings::medium_samples places on each ray, as far as they are of use. With Media::area_first the samples
  /// of the light come with them, one each.
  void place(const RayQueue& rays, const LightChoice& choice, VertexQueue& vertices, ConnectionQueue& samples);

 private:
  struct Place {
    V3f position, direction;  // of the ray
    Rgb throughput;
    std::uint32_t path, index, light;  // index: of the path's places
  };

  void march(const RayQueue& rays, VertexQueue& vertices) const;
  Rgb step_weight(float x, float loss, float length) const;
  void repeat(const RayQueue& rays);
  void choose_lights(const LightChoice& choice);
  void choose_distances();
  void add_chosen(const RayQueue& rays, VertexQueue& vertices) const;
  void connect(const VertexQueue& vertices, ConnectionQueue& samples) const;
  void add(const Place& place, std::size_t block, VertexQueue& vertices) const;
  V3f pivot(const LightFacts& light, std::size_t path, std::uint32_t sequence) const;
  std::uint32_t sequence(std::size_t path, std::uint32_t index) const {
    return static_cast<std::uint32_t>(path % stage_.settings.spp) * count_ + index;
  }

  const Stage& stage_;
  const std::uint32_t count_;  // of places on a ray
  RayColumns slots_;           // the rays, once for each place; those of a ray follow each other
  ConnectionQueue chosen_;     // lights
  VectorColumns pivots_, normals_;
  std::vector<float> lit_begin_, lit_end_;
  std::vector<float> u_, distance_, pdf_;
};

}  // namespace wavefront
