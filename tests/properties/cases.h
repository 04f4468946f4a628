// What the properties are tried on: any valid light with any of its maps, points that hug its plane, rim, corners and
// centre or are no points at all, variates on the edge of the square and beyond. RapidCheck shrinks what breaks a
// property to the simplest that does.
#pragma once

#include "support/sampler.h"
#include "support/workloads.h"

#include <hatbox/hatbox.h>

#include <rapidcheck.h>

#include <ostream>
#include <string>
#include <variant>
#include <vector>

namespace hatbox::test {

using AnyLight = std::variant<Disk, Ellipse, Rectangle, Triangle>;

/// A light, its map by number, and the lanes of a call.
struct Case {
  AnyLight light;
  std::size_t map = 0;
  std::vector<Vec3> points;
  std::vector<float> u, v;

  std::size_t size() const { return points.size(); }
  std::string map_name() const;
  PointArrays point_arrays() const;
  Variates variates() const { return {u, v}; }
  Sampler sampler() const;
  Outline outline() const;

  /// Whether the light is one, which a scaled one need not be.
  bool is_light() const;

  /// Whether lane i ought to be sampled.
  bool samplable(std::size_t i) const;

  /// Light and points scaled about the world's origin.
  Case scaled(float factor) const;

  /// Whether it has the light and point i of another case: scaling to denormals and back loses bits.
  bool same_lane(const Case& other, std::size_t i) const;

  /// The world turned: x, y, z become y, -z, -x.
  Case turned() const;

  /// Whether the map is continuous, and its inverse, where lane i takes it: not where u wraps around, not next to a
  /// point that it winds about, and not where the square is torn.
  bool continuous_at(std::size_t i) const;

  /// How far the density may be from 1/Ω, over 1/Ω, in gentle cases.
  double uniformity() const;
};

std::ostream& operator<<(std::ostream& out, const Case& c);

/// Anything that `check` lets through, and any lanes.
rc::Gen<Case> any_case();

/// Lights of ordinary shape, and lanes next to nothing: no float's rounding is magnified by more than some ten.
rc::Gen<Case> gentle_case();

}  // namespace hatbox::test
