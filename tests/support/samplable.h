// Which lanes ought to be sampled, in double and by plain geometry: without this an implementation that gave 0
// everywhere would break no rule. What is next to the limits of float is left undecided.
#pragma once

#include "support/outline.h"

namespace hatbox::test {

/// A light as seen by the judgement: its plane, its area, its size.
class Samplable {
 public:
  explicit Samplable(const Outline& outline);

  /// Whether a point is so clearly in front of the light that every map must sample it: higher above the plane than a
  /// millionth of its distance, that between 1e-6 and 1e6 light sizes, all lengths and the density in the middle of the
  /// range of floats. And higher than `least_height` light sizes, what a map itself may need.
  bool from(const Vec3& point, double least_height = 0) const;

  /// Whether a pair of variates is of the square or will be clamped to it.
  static bool by(float u, float v);

 private:
  reference::Vector<double> origin_, middle_, normal_;  // the middle's place from the origin
  double size_, area_;
  bool ordinary_;  // the light's own numbers are in the middle of the range of floats
};

/// The height, in sizes of the light, below which a map may give up.
template <class Map>
double least_height(const Map&) {
  return 0;
}
inline double least_height(DiskMap map) {
  return map == DiskMap::parallel_carlson ? 1e-8 : 0;  // its R_J would leave the range of floats
}

}  // namespace hatbox::test
