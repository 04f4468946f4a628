// RectangleMap::area: uniform over the rectangle's area. Nothing else is cheaper, so this is the yardstick of the other
// maps; it is written to cost as little as it can.
#pragma once

#include "area_ray.h"
#include "rectangle_local.h"

namespace hatbox::HATBOX_ISA {
namespace {

template <class V>
class RectangleArea {
 public:
  static constexpr bool is_cheap = true;  // so cheap that where the light lies counts

  HATBOX_INLINE RectangleArea(const RectangleLight<V>& light, V x, V y, V z) : light_(light), point_{x, y, z} {
    for (int i = 0; i < 3; ++i) l_[i] = (V(light.corner[i]) - point_[i]) * V(light.inverse_unit);
    height_ = dot(l_, light.axes_hi[2], light.axes_lo[2]);  // next to the plane the products cancel
    volume_ = V(light.area) * abs(height_);
  }

  HATBOX_INLINE LightSample<V> sample(V u, V v) const {
    const Place<V> place = {clamp_variate(u), clamp_variate(v)};
    return to(place).sample(place, height_, light_.unit, u, v);
  }

  V pdf_of_place(const Place<V>& place) const { return to(place).pdf_where(on_unit_square(place)); }

  V pdf_of_direction(const V (&direction)[3]) const {
    const V distance = height_ / along(light_.axes_hi[2], direction);
    const Mask<V> inside = RectangleLocal<V>(light_, point_[0], point_[1], point_[2]).hit(direction).inside;
    return area_pdf(distance, volume_, inside && (distance > V(0)));
  }

  Square<V> invert(const V (&direction)[3]) const {
    const RectangleLocal<V> local(light_, point_[0], point_[1], point_[2]);
    const RectangleHit<V> hit = local.hit(direction);
    const Place<V> place = local.place_at(hit.x - local.x0, hit.y - local.y0);
    return {select(hit.inside, clamp_variate(place.s), V(-1)), select(hit.inside, clamp_variate(place.t), V(-1))};
  }

 private:
  HATBOX_INLINE AreaRay<V> to(const Place<V>& place) const {
    return {l_, light_.edges[0], light_.edges[1], place, volume_};
  }

  const RectangleLight<V>& light_;
  V point_[3];
  V l_[3];    // from the shading point to the corner, in units
  V height_;  // signed, along the normal
  V volume_;  // area · |height|, for the density of a direction
};

}  // namespace
}  // namespace hatbox::HATBOX_ISA
