// What the maps that invert the paper's elliptic integrals by Newton's method share.
//
// Both solid angles come as a difference of terms near π/2 or larger, eq. 11 and 19 of Guillén et al. 2017.
// DLMF 19.21.12 turns either, without approximation, into a sum of two positive terms, an arc tangent and an R_J: right
// to a few ulp for a light of any size, where φ − c Π has lost all digits at 1e-6 sr.
#pragma once

#include "carlson.h"
#include "disk_cone.h"

namespace hatbox::HATBOX_ISA {
namespace {

/// atan(ab x)/(ab) for x >= 0, also where ab underflows.
template <class V>
HATBOX_INLINE inline V atan_by_ab(const SphericalEllipse<V>& cone, V x) {
  const V tangent = cone.a * cone.b * x;
  const Mask<V> steep = tangent > V(1);
  const V angle = atan_unit(select(steep, V(1) / tangent, tangent));
  const V radians = select(steep, constant<V>(pi / 2) - angle, angle);
  return select(tangent < constant<V>(0x1p-20), x, radians * cone.inverse_ab);
}

template <class V>
HATBOX_INLINE inline V duplicate_rj(Mask<V> valid, V x, V y, V z, V p) {
  return duplicate_rf_rj<Wanted::third>(valid, x, y, z, p).rj;
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
