// Directions all over the sphere of a shading point, sorted by where they go, and weights that integrate over those to
// a light: polar coordinates in its plane, Gauss's rule to the rim. What is smooth on the light converges to rounding.
#pragma once

#include "reference/vector.h"
#include "support/outline.h"

#include <hatbox/arrays.h>

#include <vector>

namespace hatbox::test {

struct DirectionArrays {
  std::vector<float> x, y, z;

  std::size_t size() const { return x.size(); }
  Directions view() const { return {x, y, z}; }
  void push_back(const reference::Vector<double>& direction);
};

struct SphereQuadrature {
  SphereQuadrature(const Outline& light, const Vec3& point);

  DirectionArrays hits;
  std::vector<double> weights;                 // of the hits, steradians
  std::vector<float> s, t;                     // the places of the hits
  std::vector<reference::Vector<double>> rim;  // unit directions to it, one after the other
  DirectionArrays misses;                      // in the plane outside of the rim, along the plane, and away from it
};

}  // namespace hatbox::test
