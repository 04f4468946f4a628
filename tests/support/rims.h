// Spherical ellipses by what their maps go by: k' and cos β.
#pragma once

#include "reference/spherical_ellipse.h"

#include <cmath>

namespace hatbox::test {

inline reference::SphericalEllipse seen(double k_prime, double cos_beta) {
  const double cos_alpha = k_prime * cos_beta;
  return reference::SphericalEllipse(
      {std::sqrt((1 - cos_alpha) * (1 + cos_alpha)), std::sqrt((1 - cos_beta) * (1 + cos_beta)), cos_alpha, cos_beta});
}

}  // namespace hatbox::test
