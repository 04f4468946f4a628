// All lights of a scene under one number each: hatbox's set of them, and what the renderer itself wants to know of one.
#pragma once

#include "sampler.h"
#include "scene.h"

#include <hatbox/light_set.h>

#include <optional>

namespace wavefront {

/// Places of a light are origin + s·u + t·v, with (s, t) in the unit disk, the unit square or, as s + t <= 1, its lower
/// half. Its front is where u × v points.
struct LightFacts {
  enum class Domain { disk, square, triangle };
  Domain domain;
  V3f origin, u, v;
  Rgb radiance;
  bool double_sided;
  V3f centre, normal;  // the rest follows from the above
  float area;
  float luminance;

  /// Uniform in area.
  V3f place(Sample2 sample) const;

  bool shines_on(const V3f& point) const { return double_sided || normal.dot(point - centre) > 0; }
  float power() const { return luminance * area * (double_sided ? 2.0f : 1.0f); }
};

float luminance(const Rgb& colour);

class LightTable {
 public:
  explicit LightTable(const Scene& scene);

  hatbox::LightSet make_set(const hatbox::LightSet::Maps& maps) const {
    return {disks_, ellipses_, rectangles_, triangles_, maps};
  }

  std::size_t size() const { return facts_.size(); }
  const LightFacts& operator[](std::uint32_t light) const { return facts_[light]; }

  /// The light that a triangle of an emitter's mesh is, or its shape if that is no mesh. Nothing for a triangle that is
  /// too thin for a light.
  std::optional<std::uint32_t> find(std::size_t emitter, std::uint32_t triangle) const;

 private:
  void add(const hatbox::Disk& disk);
  void add(const hatbox::Ellipse& ellipse);
  void add(const hatbox::Rectangle& rectangle);
  void add(const MeshLight& mesh);
  void add_facts(LightFacts::Domain domain, const V3f& origin, const V3f& u, const V3f& v);

  std::vector<hatbox::Disk> disks_;
  std::vector<hatbox::Ellipse> ellipses_;
  std::vector<hatbox::Rectangle> rectangles_;
  std::vector<hatbox::Triangle> triangles_;
  std::vector<LightFacts> facts_;
  const Emitter* emitter_ = nullptr;                    // whose light is being added
  std::vector<std::vector<std::uint32_t>> by_emitter_;  // of a mesh by its triangles, otherwise one number
};

}  // namespace wavefront
