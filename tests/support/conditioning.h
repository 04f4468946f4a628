// What the rounding of the inputs makes of a result.
#pragma once

#include "reference/vector.h"
#include "support/statistics.h"

#include <hatbox/ellipse.h>

#include <algorithm>
#include <cmath>

namespace hatbox::test {

/// Σ |∂f/∂xᵢ| ulp(xᵢ) over the coordinates of centre, axes and point, by steps of one ulp: of f(light, point), whose
/// values are distance(a, b) apart.
template <class Function, class Distance>
double conditioning(Ellipse light, Vec3 point, const Function& f, const Distance& distance) {
  double sum = 0;
  for (Vec3* v : {&point, &light.center, &light.semi_axis_u, &light.semi_axis_v}) {
    for (float* x : {&v->x, &v->y, &v->z}) {
      const float here = *x;
      *x = here + static_cast<float>(ulp(here));
      const auto ahead = f(light, point);
      *x = here - static_cast<float>(ulp(here));
      const auto behind = f(light, point);
      *x = here;
      sum += distance(ahead, behind) / 2;
    }
  }
  return sum;
}

/// The relative change of a reference's density within an ulp of each coordinate of the direction: what a float
/// direction hides. The solid-angle maps have none.
template <class Reference, class Map>
double pdf_conditioning(const Reference& seen, Map map, const reference::Vector<double>& direction) {
  if (map != Map::area) return 0;
  const double here = seen.pdf(map, direction);
  double sum = 0;
  for (const auto coordinate :
       {&reference::Vector<double>::x, &reference::Vector<double>::y, &reference::Vector<double>::z}) {
    reference::Vector<double> moved = direction;
    moved.*coordinate += 1e-3 * ulp(static_cast<float>(moved.*coordinate));
    const double there = seen.pdf(map, moved);
    if (there > 0 && here > 0) sum += std::abs(there / here - 1) / 1e-3;
  }
  return sum;
}

/// How much (u, v) changes within an ulp of 1 along each axis: what a float direction, made in axes that are not the
/// light's, hides from the inverse of a map, which must be one in double.
template <class Map>
double inverse_conditioning(const Map& map, const reference::Vector<double>& d) {
  const auto at = [&](const reference::Vector<double>& q) {
    const double direction[3] = {q.x, q.y, q.z};
    return map.invert(direction);
  };
  const auto here = at(d);
  double sum = 0;
  for (const auto coordinate :
       {&reference::Vector<double>::x, &reference::Vector<double>::y, &reference::Vector<double>::z}) {
    constexpr double share = 1e-2;
    reference::Vector<double> moved = d;
    moved.*coordinate += share * 0x1p-23;
    const auto there = at(moved);
    sum += std::max(std::abs(there.u - here.u), std::abs(there.v - here.v)) / share;
  }
  return sum;
}

}  // namespace hatbox::test
