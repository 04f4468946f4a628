// Carlson's symmetric elliptic integrals R_F, R_C, R_D and R_J, by duplication and a series of seventh order.
//
// Source: B. C. Carlson, "Numerical computation of real or complex elliptic integrals", Numer. Algorithms 10 (1995),
// with the series of DLMF 19.36.1-2. Every argument goes to (x + λ)/4, λ = √x√y + √x√z + √y√z, until all are near their
// mean. A lane that has come so far is frozen: its bits do not depend on how long its neighbours take.
//
// R_J's sum of R_C(1, 1 + e), e = Π(√p − √x)/Π(√p + √x), is without cancellation since 1 + e = 2√p (p + λ)/Π(√p + √x):
// all of its terms are positive.
#pragma once

#include "fma.h"

namespace hatbox::HATBOX_ISA {
namespace {

/// How near the arguments must be to their mean, relative to it, for the series to be as good as the arithmetic.
template <class V>
inline constexpr double series_reach = std::is_same_v<Scalar<V>, double> ? 0.008 : 0.15;

/// The mean A_n of the arguments after n steps and what the series wants to know of it.
template <class V>
struct Mean {
  V value;       // A_n
  V shrink;      // 4^-n
  V dx, dy, dz;  // A_0 − x_0 …, which is 4^n (A_n − x_n) …
  V reach;       // the series will do when A_n is 4^-n times this

  HATBOX_INLINE Mean(Mask<V> valid, V mean, V x, V y, V z, V p)
      : value(mean), shrink(V(1)), dx(mean - x), dy(mean - y), dz(mean - z) {
    const V farthest = max(max(abs(dx), abs(dy)), max(abs(dz), abs(mean - p)));
    reach = select(valid, farthest * constant<V>(1 / series_reach<V>), V(0));
  }
  HATBOX_INLINE Mask<V> is_far() const { return reach * shrink > value; }
  HATBOX_INLINE void step(Mask<V> active, V quarter_lambda) {
    value = select(active, fma(V(0.25), value, quarter_lambda), value);
    shrink = select(active, V(0.25) * shrink, shrink);
  }
};

/// DLMF 19.36.1, for R_F.
template <class V>
HATBOX_INLINE inline V series_rf(const Mean<V>& mean) {
  const V inverse = V(1) / mean.value;
  const V scale = mean.shrink * inverse;
  const V X = mean.dx * scale, Y = mean.dy * scale, Z = mean.dz * scale;
  const V E2 = fma(X, Y, -(Z * Z));
  const V E3 = X * Y * Z;
  const V in_E2 = fma(fma(constant<V>(-5.0 / 208), E2, constant<V>(1.0 / 24)), E2, constant<V>(-1.0 / 10));
  const V in_E3 = fma(fma(constant<V>(1.0 / 16), E2, constant<V>(-3.0 / 44)), E2,
                      fma(constant<V>(3.0 / 104), E3, constant<V>(1.0 / 14)));
  const V root = sqrt(inverse);
  return fma(root, fma(in_E2, E2, in_E3 * E3), root);
}

/// DLMF 19.36.2, for R_J with P = −(X + Y + Z)/2, and for R_D with P = Z = −(X + Y)/3.
template <class V>
HATBOX_INLINE inline V series_rj(V inverse_mean, V X, V Y, V Z, V P) {
  const V XYZ = X * Y * Z, P2 = P * P;
  const V E2 = fma(X, Y, fma(Z, X + Y, V(-3) * P2));
  const V E3 = fma(V(2) * P, fma(V(2), P2, E2), XYZ);
  const V E4 = fma(P, fma(V(3), P2, E2), V(2) * XYZ) * P;
  const V E5 = XYZ * P2;
  const V in_E2 = fma(fma(constant<V>(-1.0 / 16), E2, constant<V>(9.0 / 88)), E2, constant<V>(-3.0 / 14));
  const V in_E3 = fma(fma(constant<V>(45.0 / 272), E2, constant<V>(-9.0 / 52)), E2,
                      fma(constant<V>(3.0 / 40), E3, constant<V>(1.0 / 6)));
  const V in_E4 = fma(constant<V>(3.0 / 20), E2, fma(constant<V>(-9.0 / 68), E3, constant<V>(-3.0 / 22)));
  const V in_E5 = fma(constant<V>(-9.0 / 68), E2, constant<V>(3.0 / 26));
  const V sum = fma(in_E2, E2, fma(in_E3, E3, fma(in_E4, E4, in_E5 * E5)));
  const V power = inverse_mean * sqrt(inverse_mean);
  return fma(power, sum, power);
}

template <class V>
struct Roots {
  V x, y, z;

  HATBOX_INLINE Roots(V of_x, V of_y, V of_z) : x(sqrt(of_x)), y(sqrt(of_y)), z(sqrt(of_z)) {}
  V lambda() const { return fma(x, y, z * (x + y)); }
};

// What follows does not look at lanes that are not valid, but for this: none of them keeps a loop from ending.

/// R_F of arguments whose sum does not overflow, at most one of them 0.
template <class V>
HATBOX_INLINE inline V duplicate_rf(Mask<V> valid, V x, V y, V z) {
  Mean<V> mean(valid, constant<V>(1.0 / 3) * (x + y + z), x, y, z, x);
  for (Mask<V> active = mean.is_far(); any(active); active = mean.is_far()) {
    const V quarter_lambda = V(0.25) * Roots<V>(x, y, z).lambda();
    x = fma(V(0.25), x, quarter_lambda);
    y = fma(V(0.25), y, quarter_lambda);
    z = fma(V(0.25), z, quarter_lambda);
    mean.step(active, quarter_lambda);
  }
  return series_rf(mean);
}

/// R_C of x >= 0, y > 0, whose sum does not overflow (DLMF 19.36.3 for the series, s = (y − A)/A). The next x is
/// ((√x + √y)/2)², so its root costs nothing.
template <class V>
HATBOX_INLINE inline V duplicate_rc(Mask<V> valid, V x, V y) {
  Mean<V> mean(valid, constant<V>(1.0 / 3) * (x + V(2) * y), x, y, y, y);
  V root_x = sqrt(x);
  for (Mask<V> active = mean.is_far(); any(active); active = mean.is_far()) {
    const V root_y = sqrt(y);
    mean.step(active, V(0.25) * fma(V(2) * root_x, root_y, y));
    root_x = V(0.5) * (root_x + root_y);
    y = root_x * root_y;
  }
  const V inverse = V(1) / mean.value;
  const V s = -(mean.dy * (mean.shrink * inverse));
  constexpr double series[] = {9.0 / 8, 159.0 / 208, 9.0 / 22, 3.0 / 8, 1.0 / 7, 3.0 / 10};
  V sum = constant<V>(series[0]);
  for (int i = 1; i < 6; ++i) sum = fma(sum, s, constant<V>(series[i]));
  const V root = sqrt(inverse);
  return fma(root, sum * (s * s), root);
}

/// R_C(1, 1 + e) for |e| <= 1/4, which is atan(√e)/√e: a minimax fit made for this file, within 8e-9.
template <class V>
HATBOX_INLINE inline V rc_near_one(V e) {
  constexpr double fit[] = {-0.0749419533595, 0.0848365850948, -0.0904956233842, 0.110794380303,
                            -0.142864785049,  0.200004008753,  -0.333333294632,  0.999999992108};
  V sum = constant<V>(fit[0]);
  for (int i = 1; i < 8; ++i) sum = fma(sum, e, constant<V>(fit[i]));
  return sum;
}

inline double rc_near_one(double e) {
  double sum = 0;
  for (int k = 8; k >= 0; --k) sum = std::fma(sum, -e, 1.0 / (2 * k + 1));  // |e| <= 1/64
  return sum;
}

/// R_C(1, y) for y > 0. One duplication is R_C(1, y) = 2/(1 + √y) · R_C(1, 2√y/(1 + √y)).
template <class V>
HATBOX_INLINE inline V rc_of_one(V y) {
  const V near = constant<V>(std::is_same_v<Scalar<V>, double> ? 1.0 / 64 : 1.0 / 4);
  y = max(y, constant<V>(smallest_normal<V>));  // of a lane that is not valid: from 0 there is no way to 1
  V factor = V(1);
  V e = y - V(1);
  for (Mask<V> active = abs(e) > near; any(active); active = abs(e) > near) {
    const V root = sqrt(y);
    const V doubled = V(2) / (V(1) + root);
    y = select(active, doubled * root, y);
    factor = select(active, factor * doubled, factor);
    e = y - V(1);
  }
  return factor * rc_near_one(e);
}

/// R_F(x, y, z) with R_D or R_J of the same arguments: they share all roots, and R_F comes nearly for free.
template <class V>
struct FirstAndThird {
  V rf, rj;
};

/// Whether R_F is wanted as well; if not, no lane goes on for it, and it is of no use.
enum class Wanted { third, both };

/// The two means, each frozen by itself, so that R_D and R_J have the same bits with R_F and without.
template <Wanted wanted, class V>
struct Means {
  Mean<V> first, third;

  HATBOX_INLINE Mask<V> either_is_far() const {
    if constexpr (wanted == Wanted::third) return third.is_far();
    return first.is_far() || third.is_far();
  }
  HATBOX_INLINE void step(Mask<V> active, V quarter_lambda) {
    first.step(first.is_far(), quarter_lambda);
    third.step(active, quarter_lambda);
  }
};

/// R_F(x, y, z) and R_D(x, y, z). At most one of x and y is 0, z > 0; of the size ThirdKindScale gives them, or near 1.
template <Wanted wanted, class V>
HATBOX_INLINE inline FirstAndThird<V> duplicate_rf_rd(Mask<V> valid, V x, V y, V z) {
  Means<wanted, V> means{{valid, constant<V>(1.0 / 3) * (x + y + z), x, y, z, x},
                         {valid, constant<V>(1.0 / 5) * (x + y + V(3) * z), x, y, z, x}};
  V sum = V(0);
  while (any(means.either_is_far())) {
    const Mask<V> active = means.third.is_far();
    const Roots<V> roots(x, y, z);
    const V lambda = roots.lambda();
    sum = select(active, sum + means.third.shrink / (roots.z * (z + lambda)), sum);
    const V quarter_lambda = V(0.25) * lambda;
    x = fma(V(0.25), x, quarter_lambda);
    y = fma(V(0.25), y, quarter_lambda);
    z = fma(V(0.25), z, quarter_lambda);
    means.step(active, quarter_lambda);
  }
  const V inverse = V(1) / means.third.value;
  const V scale = means.third.shrink * inverse;
  const V X = means.third.dx * scale, Y = means.third.dy * scale;
  const V Z = constant<V>(-1.0 / 3) * (X + Y);
  return {series_rf(means.first), fma(means.third.shrink, series_rj(inverse, X, Y, Z, Z), V(3) * sum)};
}

/// R_F(x, y, z) and R_J(x, y, z, p). At most one of x, y, z is 0, p > 0; of the size ThirdKindScale gives them, or
/// near 1.
template <Wanted wanted, class V>
HATBOX_INLINE inline FirstAndThird<V> duplicate_rf_rj(Mask<V> valid, V x, V y, V z, V p) {
  Means<wanted, V> means{{valid, constant<V>(1.0 / 3) * (x + y + z), x, y, z, x},
                         {valid, constant<V>(1.0 / 5) * (x + y + z + V(2) * p), x, y, z, p}};
  V sum = V(0);
  while (any(means.either_is_far())) {
    const Mask<V> active = means.third.is_far();
    const Roots<V> roots(x, y, z);
    const V lambda = roots.lambda();
    const V root_p = sqrt(p);
    const V inverse_d = V(1) / ((root_p + roots.x) * (root_p + roots.y) * (root_p + roots.z));
    const V rc = rc_of_one(V(2) * root_p * (p + lambda) * inverse_d);
    sum = select(active, fma(means.third.shrink * inverse_d, rc, sum), sum);
    const V quarter_lambda = V(0.25) * lambda;
    x = fma(V(0.25), x, quarter_lambda);
    y = fma(V(0.25), y, quarter_lambda);
    z = fma(V(0.25), z, quarter_lambda);
    p = fma(V(0.25), p, quarter_lambda);
    means.step(active, quarter_lambda);
  }
  const V inverse = V(1) / means.third.value;
  const V scale = means.third.shrink * inverse;
  const V X = means.third.dx * scale, Y = means.third.dy * scale, Z = means.third.dz * scale;
  const V P = V(-0.5) * (X + Y + Z);
  return {series_rf(means.first), fma(means.third.shrink, series_rj(inverse, X, Y, Z, P), V(6) * sum)};
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
