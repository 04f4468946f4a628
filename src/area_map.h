// Uniform over the area of a disk or an ellipse by the concentric map (Shirley and Chiu 1997). Nothing else is cheaper,
// so this is the yardstick of the other maps; it is written to cost as little as it can.
#pragma once

#include "area_ray.h"
#include "ellipse_cone.h"

namespace hatbox::HATBOX_ISA {
namespace {

// What a place's coordinates span, in units of the radius, along the light's own axes; what those give back by; the
// area in these units; and a place from the caller's axes to the light's own, or back.
template <class V>
inline const V (&span(const DiskLight<V>& light, int i))[3] {
  return light.axes[i];
}
template <class V>
inline V inverse_span(const DiskLight<V>&, int) {
  return V(1);
}
template <class V>
inline V area_of(const DiskLight<V>&) {
  return constant<V>(pi);
}
template <class V>
inline Place<V> sorted_place(const DiskLight<V>&, const Place<V>& place) {
  return place;
}
template <class V>
inline const V (&span(const EllipseLight<V>& light, int i))[3] {
  return i == 0 ? light.axes[0] : light.shorter_axis;
}
template <class V>
inline V inverse_span(const EllipseLight<V>& light, int i) {
  return i == 0 ? V(1) : light.inverse_ratio;
}
template <class V>
inline V area_of(const EllipseLight<V>& light) {
  return constant<V>(pi) * light.ratio;
}

template <class Cone>
class AreaMap {
 public:
  static constexpr bool is_cheap = true;  // so cheap that where the light lies counts

  using V = typename Cone::Vector;
  using Light = typename Cone::Light;

  HATBOX_INLINE AreaMap(const Light& light, V x, V y, V z) : light_(light), point_{x, y, z} {
    for (int i = 0; i < 3; ++i) l_[i] = (V(light.center[i]) - point_[i]) * V(light.inverse_radius);
    height_ = along(light.axes[2], l_);
    // The projection of an area A on a sphere of distance 1 is A|h|/distance³.
    volume_ = V(area_of(light)) * abs(height_);
  }

  HATBOX_INLINE LightSample<V> sample(V u, V v) const {
    const Polar<V> polar = concentric(u, v);
    const Place<V> place = {polar.radius * polar.angle.cos, polar.radius * polar.angle.sin};
    return to(place).sample(place, height_, light_.radius, u, v);
  }

  V pdf_of_place(const Place<V>& place) const { return to(place).pdf_where(on_unit_disk(place)); }

  V pdf_of_direction(const V (&direction)[3]) const {
    const Hit hit = intersect(direction);
    return area_pdf(hit.distance, volume_, hit.inside);
  }

  Square<V> invert(const V (&direction)[3]) const {
    const Hit hit = intersect(direction);
    const V r = sqrt(fma(hit.place.s, hit.place.s, hit.place.t * hit.place.t));
    const V inverse_r = V(1) / select(r > V(0), r, V(1));
    const SinCos<V> angle = {hit.place.t * inverse_r, select(r > V(0), hit.place.s * inverse_r, V(1))};
    const Square<V> square = concentric_inverse(Polar<V>{min(r, V(1)), angle});
    return {select(hit.inside, clamp_variate(square.u), V(-1)), select(hit.inside, clamp_variate(square.v), V(-1))};
  }

 private:
  struct Hit {
    V distance;  // in units of the light
    Place<V> place;
    Mask<V> inside;
  };

  HATBOX_INLINE AreaRay<V> to(const Place<V>& place) const {
    return {l_, span(light_, 0), span(light_, 1), sorted_place(light_, place), volume_};
  }

  Hit intersect(const V (&direction)[3]) const {
    const Cone cone(light_, point_[0], point_[1], point_[2]);
    Hit hit;
    hit.distance = height_ / along(light_.axes[2], direction);
    V coordinate[2];
    for (int i = 0; i < 2; ++i) {
      const V offset = fma(hit.distance, along(light_.axes[i], direction), -along(light_.axes[i], l_));
      coordinate[i] = offset * V(inverse_span(light_, i));
    }
    hit.place = sorted_place(light_, Place<V>{coordinate[0], coordinate[1]});
    hit.inside = cone.hit(direction).inside && (hit.distance > V(0)) && is_finite(hit.distance);
    return hit;
  }

  const Light& light_;
  V point_[3];
  V l_[3];    // from the shading point to the light's centre, in its units
  V height_;  // signed, along the normal
  V volume_;  // area · |height|, for the density of a direction
};

}  // namespace
}  // namespace hatbox::HATBOX_ISA
