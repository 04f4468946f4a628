// What the rounding of the inputs makes of a result.
#pragma once

#include "support/statistics.h"

#include <hatbox/ellipse.h>

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

}  // namespace hatbox::test
