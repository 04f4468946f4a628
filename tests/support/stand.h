// A place where lights of every kind stand: for tests that think of any light, each in its own way.
#pragma once

#include "support/frames.h"

#include <hatbox/lights.h>

namespace hatbox::test {

/// The lights' common corner or centre, axes and sizes.
struct Stand {
  reference::Vector<double> origin{0, 0, 0};
  Frame axes;
  double size = 1, aspect = 1;

  reference::Vector<double> at(double u, double v, double n) const {
    return origin + size * (u * axes.u + v * axes.v + n * axes.n);
  }

  Disk disk() const { return {rounded(origin), rounded(axes.n), static_cast<float>(size)}; }
  Ellipse ellipse() const { return {rounded(origin), side_u(), side_v()}; }
  Rectangle rectangle() const { return {rounded(origin), side_u(), side_v()}; }
  /// Its third vertex is above `foot` of its base.
  Triangle triangle(double foot) const { return {rounded(origin), rounded(at(1, 0, 0)), rounded(at(foot, aspect, 0))}; }

  Vec3 side_u() const { return rounded(size * axes.u); }
  Vec3 side_v() const { return rounded(size * aspect * axes.v); }
};

}  // namespace hatbox::test
