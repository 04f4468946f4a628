// The area-preserving map in the angle η of the orthographic ellipse, from a table made in advance (eta_rows.h). It has
// the form of the series of eta_series.h,
//   η(θ) = θ + ½ sin 2θ · P(cos 2θ),
// and the table gives P for all ellipses: with A, the amplitude of η − θ to first order, and a number σ for the shape,
//   P(x) = A (D(x; σ) − 1),   A = (cos β − cos α)/(2 + cos α + cos β),
//   σ² = (1 − k')/(1 + k') · (2 − cos α − cos β)/(2 + cos α + cos β).
// An ellipse has two numbers, cos β and k' = cos α/cos β, and D but one, so this is an approximation. P's second
// harmonic is, over the first, k'-dependent times 1 − 2f with f the share of h in 1 + h; σ² is that product, so
// ellipses with one σ agree to second order whatever their A. Variation of the density at 99 % (99.9 %) of W1 for ideal
// tables: over A alone, rows of cos β = 1, 6e-4 (4e-3); over k', with A as a factor, 3e-4 to 5e-4 (2e-3); over σ
// 1.3e-4 (1e-3), with the rows that eta_rows.cpp takes.
//
// Over x, D is a uniform quadratic B-spline: three coefficients give it and its derivative, which is continuous.
// Between two rows it is linear in σ. So six numbers are gathered, by all lanes alike, and the derivative is exact:
// what table and interpolation cost is never bias, only uniformity.
#pragma once

#include "disk_light.h"
#include "eta_series.h"

namespace hatbox::HATBOX_ISA {
namespace {

template <class V>
class EtaTable {
 public:
  HATBOX_INLINE EtaTable(const TabulatedDiskLight<V>& light, const SphericalEllipse<V>& cone);

  AngleShift<V> operator()(const SinCos<V>& theta) const;
  UniformAngle<V> uniform_angle(const SinCos<V>& eta) const { return solve_uniform_angle(*this, eta); }

 private:
  const float* coefficients_;
  std::size_t resolution_;
  Scalar<V> cells_;  // a row has two coefficients more
  V amplitude_;      // A
  V row_;            // where in the table the row below σ begins
  V weight_;         // of the row after it
};

/// The place in a table of an index >= 0 and at most `last`; for NaN, which invalid lanes may bring, any in the table.
template <class V>
inline V cell_of(V position, Scalar<V> last) {
  return truncate(max(min(position, V(last)), V(0)));
}

template <class V>
HATBOX_INLINE inline EtaTable<V>::EtaTable(const TabulatedDiskLight<V>& light, const SphericalEllipse<V>& cone)
    : coefficients_(light.coefficients),
      resolution_(light.resolution),
      cells_(static_cast<Scalar<V>>(light.resolution - 2)) {
  const V one_plus_k = V(1) + sqrt(cone.k2);
  const V sum = cone.cos_beta * one_plus_k;  // cos α + cos β
  // The differences are small ones of rounded numbers, but what is small of A or σ hardly counts.
  const V shared = max(V(1) - cone.k2, V(0)) / (one_plus_k * one_plus_k * (V(2) + sum));
  amplitude_ = sum * shared;
  const V sigma = sqrt(max(shared * (V(2) - sum), V(0)));
  const V position = sigma * V(cells_ + Scalar<V>(1));
  const V row = cell_of(position, cells_);
  row_ = row * V(static_cast<Scalar<V>>(resolution_));
  weight_ = position - row;
}

template <class V>
inline AngleShift<V> EtaTable<V>::operator()(const SinCos<V>& theta) const {
  const auto [s, x] = doubled(theta);
  const V half = V(Scalar<V>(0.5) * cells_);
  const V position = fma(x, half, half);
  const V cell = cell_of(position, cells_ - Scalar<V>(1));
  const V t = position - cell;
  const V index = row_ + cell;
  const auto coefficient = [&](std::size_t i) {
    const V here = gather(coefficients_ + i, index);
    return fma(weight_, gather(coefficients_ + resolution_ + i, index) - here, here);
  };
  const V c0 = coefficient(0), c1 = coefficient(1), c2 = coefficient(2);
  const V left = c1 - c0;
  const V by_t = fma(t, (c2 - c1) - left, left);
  const V D = V(0.5) * fma(t, left + by_t, c0 + c1);
  const V value = fma(amplitude_, D, -amplitude_);
  const V derivative = amplitude_ * (half * by_t);
  // d/dθ [½ s P(x)] with x = cos 2θ, s = sin 2θ
  return {V(0.5) * s * value, fma(-(s * s), derivative, fma(x, value, V(1)))};
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
