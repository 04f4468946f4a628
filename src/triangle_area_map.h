// TriangleMap::area: uniform over the triangle's area by the low-distortion map of Heitz 2019, "A Low-Distortion Map
// Between Triangle and Square". Nothing else is cheaper, so this is the yardstick of the other map.
#pragma once

#include "area_ray.h"
#include "triangle_map.h"

namespace hatbox::HATBOX_ISA {
namespace {

template <class V>
class TriangleArea {
 public:
  static constexpr bool is_cheap = true;  // so cheap that where the light lies counts

  HATBOX_INLINE TriangleArea(const TriangleLight<V>& light, V x, V y, V z) : light_(light), point_{x, y, z} {
    for (int i = 0; i < 3; ++i) l_[i] = (V(light.vertex[i]) - point_[i]) * V(light.inverse_unit);
    height_ = dot(l_, light.axes_hi[2], light.axes_lo[2]);  // next to the plane the products cancel
    volume_ = V(light.area) * abs(height_);
  }

  HATBOX_INLINE LightSample<V> sample(V u, V v) const {
    const V clamped_u = clamp_variate(u), clamped_v = clamp_variate(v);
    const V half = V(0.5) * min(clamped_u, clamped_v);
    const Mask<V> upper = clamped_v > clamped_u;
    const Place<V> place = {select(upper, half, clamped_u - half), select(upper, clamped_v - half, half)};
    return to(place).sample(place, height_, light_.unit, u, v);
  }

  V pdf_of_place(const Place<V>& place) const { return to(place).pdf_where(on_unit_triangle(place)); }

  V pdf_of_direction(const V (&direction)[3]) const {
    const Hit hit = intersect(direction);
    return area_pdf(hit.distance, volume_, hit.inside);
  }

  Square<V> invert(const V (&direction)[3]) const {
    const Hit hit = intersect(direction);
    const V s = hit.place.s, t = hit.place.t;
    const V twice = V(2) * min(s, t);
    const Mask<V> upper = t > s;
    const V u = select(upper, twice, s + t), v = select(upper, s + t, twice);
    return {select(hit.inside, clamp_variate(u), V(-1)), select(hit.inside, clamp_variate(v), V(-1))};
  }

 private:
  struct Hit {
    V distance;  // in units of the light
    Place<V> place;
    Mask<V> inside;
  };

  HATBOX_INLINE AreaRay<V> to(const Place<V>& place) const {
    return {l_, light_.edges[0], light_.edges[1], place, volume_};
  }

  Hit intersect(const V (&direction)[3]) const {
    const TriangleView<V> view(light_, point_[0], point_[1], point_[2]);
    const auto seen = view.hit(direction);
    Hit hit;
    hit.distance = height_ / along(light_.axes_hi[2], direction);
    hit.place = view.spherical.place_of(seen.direction);
    hit.inside = seen.inside && (hit.distance > V(0)) && is_finite(hit.distance);
    return hit;
  }

  const TriangleLight<V>& light_;
  V point_[3];
  V l_[3];    // from the shading point to a, in units of the light
  V height_;  // of the plane, signed along the normal
  V volume_;  // area · |height|, for the density of a direction
};

}  // namespace
}  // namespace hatbox::HATBOX_ISA
