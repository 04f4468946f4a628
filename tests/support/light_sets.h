// Lights of all kinds for the tests of sets, and a set as a sampler like any other.
#pragma once

#include "support/sampler.h"
#include "support/workloads.h"

#include <hatbox/hatbox.h>

#include <cstdint>
#include <vector>

namespace hatbox::test {

/// Some lights of each kind, of all shapes and sizes, among the points of workloads.h.
struct MixedLights {
  MixedLights(Pose pose, std::size_t of_each_kind);

  std::size_t size() const { return disks.size() + ellipses.size() + rectangles.size() + triangles.size(); }
  LightSet set(const LightSet::Maps& maps) const { return {disks, ellipses, rectangles, triangles, maps}; }

  /// The light that a set has at an index, by itself.
  Sampler alone(std::size_t index, const LightSet::Maps& maps) const;

  std::vector<Disk> disks;
  std::vector<Ellipse> ellipses;
  std::vector<Rectangle> rectangles;
  std::vector<Triangle> triangles;
};

/// An index below `lights` for each of n points, at random.
std::vector<std::uint32_t> random_choices(std::size_t n, std::size_t lights);

/// A set, with a light for each of the points that its calls will be made with.
Sampler sampler_of(const LightSet& set, const std::vector<std::uint32_t>& chosen);

}  // namespace hatbox::test
