// RectangleMap::area: uniform over the rectangle's area. Nothing else is cheaper, so this is the yardstick of the other
// maps; it is written to cost as little as it can.
#pragma once

#include "rectangle_local.h"

namespace hatbox::HATBOX_ISA {
namespace {

template <class V>
class RectangleAreaMap {
 public:
  HATBOX_INLINE RectangleAreaMap(const RectangleLight<V>& light, V x, V y, V z) : light_(light), point_{x, y, z} {
    for (int i = 0; i < 3; ++i) l_[i] = (V(light.corner[i]) - point_[i]) * V(light.inverse_unit);
    height_ = along(light.axes_hi[2], l_);
    density_ = V(light.inverse_area) / abs(height_);
  }

  HATBOX_INLINE LightSample<V> sample(V u, V v) const {
    const Place<V> place = {clamp_variate(u), clamp_variate(v)};
    const Ray ray = to(place);
    LightSample<V> out;
    for (int i = 0; i < 3; ++i) out.direction[i] = ray.l[i] * ray.inverse_distance;
    out.distance = ray.distance * V(light_.unit);
    out.pdf = ray.pdf;
    out.cosine = -height_ * ray.inverse_distance;
    out.place = place;
    out.valid = honest(ray.clear && is_finite(u + v) && is_finite(out.distance), out.pdf);
    return out;
  }

  V pdf_of_place(const Place<V>& place) const {
    const Ray ray = to(place);
    return select(honest(on_unit_square(place) && ray.clear, ray.pdf), ray.pdf, V(0));
  }

  V pdf_of_direction(const V (&direction)[3]) const {
    const V distance = height_ / along(light_.axes_hi[2], direction);
    const V density = distance * distance * density_ * distance;
    const Mask<V> inside = RectangleLocal<V>(light_, point_[0], point_[1], point_[2]).hit(direction).inside;
    return select(honest(inside && (distance > V(0)), density), density, V(0));
  }

  Square<V> invert(const V (&direction)[3]) const {
    const RectangleLocal<V> local(light_, point_[0], point_[1], point_[2]);
    const RectangleHit<V> hit = local.hit(direction);
    const Place<V> place = local.place_at(hit.x - local.x0, hit.y - local.y0);
    return {select(hit.inside, clamp_variate(place.s), V(-1)), select(hit.inside, clamp_variate(place.t), V(-1))};
  }

 private:
  struct Ray {
    V l[3];  // from the shading point to the place, in units
    V distance, inverse_distance;
    V pdf;
    Mask<V> clear;  // of the place, by more than what underflows when squared
  };

  Ray to(const Place<V>& place) const {
    Ray ray;
    for (int i = 0; i < 3; ++i) {
      ray.l[i] = fma(V(light_.edges[0][i]), place.s, fma(V(light_.edges[1][i]), place.t, l_[i]));
    }
    const V distance2 = fma(ray.l[0], ray.l[0], fma(ray.l[1], ray.l[1], ray.l[2] * ray.l[2]));
    ray.clear = distance2 >= constant<V>(smallest_normal<V>);
    ray.distance = sqrt(distance2);
    ray.inverse_distance = ray.distance * (V(1) / distance2);  // the root and the quotient run side by side
    ray.pdf = distance2 * density_ * ray.distance;
    return ray;
  }

  const RectangleLight<V>& light_;
  V point_[3];
  V l_[3];     // from the shading point to the corner, in units
  V height_;   // signed, along the normal
  V density_;  // of a direction, less the factor distance³
};

}  // namespace
}  // namespace hatbox::HATBOX_ISA
