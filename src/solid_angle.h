// The solid angle of a spherical ellipse, by Landen's transformation: positive terms only, so right to a few ulp from
// the smallest float to 2π.
//
// Ω = 4ab ∫ dη/(1 + cos β H(η)) over the quarter turn, H² = A² cos² η + B² sin² η with A = k', B = 1: eq. 16-19 of
// Guillén et al. 2017 in the angle η, where the paper's difference of two large terms is gone. One step of Gauss's form
// of Landen's transformation, A, B → (A + B)/2, √(AB), pairs the values H± with H₊ + H₋ = 2H′ and H₊H₋ = AB, and
//   ∫ R(H) dη/H = ∫ ½ (R(H₊) + R(H₋)) dη′/H′.
// It keeps R(H) = (αH + β)/(γH + δ) of its form; once A = B, H is constant and the integral is done.
#pragma once

#include "spherical_ellipse.h"

namespace hatbox::HATBOX_ISA {
namespace {

// Enough for k' of 1e-15, the least a float cone has: the relative difference of A and B squares in each step.
inline constexpr int landen_steps = 6;

template <class V>
inline V spherical_ellipse_area(const SphericalEllipse<V>& cone) {
  V A = sqrt(cone.k2), B = V(1);
  V alpha = V(1), beta = V(0), gamma = cone.cos_beta, delta = V(1);
  for (int i = 0; i < landen_steps; ++i) {
    const V AB = A * B;
    const V gamma_delta = gamma * delta;
    const V next_alpha = fma(alpha, delta, beta * gamma);
    beta = fma(alpha * gamma, AB, beta * delta);
    alpha = next_alpha;
    delta = fma(gamma * gamma, AB, delta * delta);
    gamma = gamma_delta + gamma_delta;
    A = V(0.5) * (A + B);
    B = sqrt(AB);
  }
  const V mean = fma(alpha, A, beta) / (A * fma(gamma, A, delta));
  return constant<V>(2 * pi) * cone.a * (cone.b * mean);
}

template <class V>
inline V solid_angle_of(const SphericalEllipse<V>& cone) {
  return spherical_ellipse_area(cone);
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
