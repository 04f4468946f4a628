// Of two spherical triangles one, lane by lane, for a light that is made of both: they are set up once a point, and a
// sample's choice between them is a select for each number it needs. Choosing between the triangles in their plane
// instead would be a set-up for every sample.
#pragma once

#include "spherical_triangle.h"

namespace hatbox::HATBOX_ISA {
namespace {

template <class V>
HATBOX_INLINE inline SphericalTriangle<V> SphericalTriangle<V>::either(const Mask<V>& mask,
                                                                       const SphericalTriangle& other) const {
  SphericalTriangle result = *this;
  const auto pick = [&](V& to, const V& instead) HATBOX_INLINE { to = select(mask, to, instead); };
  const auto pick_angle = [&](SinCos<V>& to, const SinCos<V>& instead) HATBOX_INLINE {
    pick(to.sin, instead.sin);
    pick(to.cos, instead.cos);
  };
  const auto pick_mask = [&](Mask<V>& to, const Mask<V>& instead)
                             HATBOX_INLINE { to = (mask && to) || (!mask && instead); };
  for (int i = 0; i < 3; ++i) {
    pick(result.unit_x_[i], other.unit_x_[i]);
    pick(result.unit_y_[i], other.unit_y_[i]);
    pick(result.unit_z_[i], other.unit_z_[i]);
    pick(result.normal_x_[i], other.normal_x_[i]);
    pick(result.normal_y_[i], other.normal_y_[i]);
    pick(result.normal_z_[i], other.normal_z_[i]);
    pick(result.span_[i], other.span_[i]);
    pick_angle(result.half_side_[i], other.half_side_[i]);
    pick(result.B_[i], other.B_[i]);
    pick(result.n_[i], other.n_[i]);
    pick(result.t_[i], other.t_[i]);
  }
  pick_mask(result.first_, other.first_);
  pick_mask(result.second_, other.second_);
  pick_angle(result.b_, other.b_);
  pick_angle(result.c_, other.c_);
  pick_angle(result.alpha_, other.alpha_);
  pick_angle(result.half_, other.half_);
  pick(result.z_, other.z_);
  pick(result.cos_a_, other.cos_a_);
  pick(result.inverse_cos_a_, other.inverse_cos_a_);
  pick(result.half_area_, other.half_area_);
  pick(result.inverse_area_, other.inverse_area_);
  pick(result.weight_A_, other.weight_A_);
  pick(result.weight_B_, other.weight_B_);
  pick(result.weight_C_, other.weight_C_);
  return result;
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
