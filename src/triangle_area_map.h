// TriangleMap::area: uniform over the triangle's area by the low-distortion map of Heitz 2019, "A Low-Distortion Map
// Between Triangle and Square". Nothing else is cheaper, so this is the yardstick of the other map.
#pragma once

#include "triangle_map.h"

namespace hatbox::HATBOX_ISA {
namespace {

template <class V>
class TriangleAreaMap {
 public:
  HATBOX_INLINE TriangleAreaMap(const TriangleLight<V>& light, V x, V y, V z) : light_(light), point_{x, y, z} {
    const V from[3] = {V(light.vertex[0]) - x, V(light.vertex[1]) - y, V(light.vertex[2]) - z};
    for (int i = 0; i < 3; ++i) l_[i] = from[i] * V(light.inverse_unit);
    height_ = dot(from, light.axes_hi[2], light.axes_lo[2]);  // next to the plane the products cancel
    density_ = V(light.inverse_area) / abs(height_);
  }

  HATBOX_INLINE LightSample<V> sample(V u, V v) const {
    const V clamped_u = clamp_variate(u), clamped_v = clamp_variate(v);
    const V half = V(0.5) * min(clamped_u, clamped_v);
    const Mask<V> upper = clamped_v > clamped_u;
    const Place<V> place = {select(upper, half, clamped_u - half), select(upper, clamped_v - half, half)};
    const Ray ray = to(place);
    LightSample<V> out;
    for (int i = 0; i < 3; ++i) out.direction[i] = ray.l[i] * ray.inverse_distance;
    out.distance = ray.distance * V(light_.unit);
    out.pdf = ray.pdf;
    out.cosine = min(max(-height_ * ray.inverse_distance, V(-1)), V(1));
    out.place = place;
    out.valid = honest(is_finite(u + v) && is_finite(out.distance + ray.inverse_distance), out.pdf);
    return out;
  }

  V pdf_of_place(const Place<V>& place) const {
    const V density = to(place).pdf;
    return select(honest(on_unit_triangle(place), density), density, V(0));
  }

  V pdf_of_direction(const V (&direction)[3]) const {
    const Hit hit = intersect(direction);
    const V density = hit.distance * hit.distance * density_ * hit.distance;
    return select(honest(hit.inside, density), density, V(0));
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
  struct Ray {
    V l[3];  // from the shading point to the place, in units of the light
    V distance, inverse_distance;
    V pdf;
  };
  struct Hit {
    V distance;  // in units of the light
    Place<V> place;
    Mask<V> inside;
  };

  Ray to(const Place<V>& place) const {
    Ray ray;
    for (int i = 0; i < 3; ++i) {
      ray.l[i] = fma(V(light_.edges[0][i]), place.s, fma(V(light_.edges[1][i]), place.t, l_[i]));
    }
    const V distance2 = fma(ray.l[0], ray.l[0], fma(ray.l[1], ray.l[1], ray.l[2] * ray.l[2]));
    ray.distance = sqrt(distance2);
    ray.inverse_distance = ray.distance * (V(1) / distance2);  // the root and the quotient run side by side
    ray.pdf = distance2 * density_ * ray.distance;
    return ray;
  }

  Hit intersect(const V (&direction)[3]) const {
    const TriangleView<V> view(light_, point_[0], point_[1], point_[2]);
    const auto seen = view.hit(direction);
    Hit hit;
    hit.distance = height_ / along(light_.axes[2], direction);
    hit.place = view.spherical.place_of(seen.direction);
    hit.inside = seen.inside && (hit.distance > V(0)) && is_finite(hit.distance);
    return hit;
  }

  const TriangleLight<V>& light_;
  V point_[3];
  V l_[3];     // from the shading point to a, in units of the light
  V height_;   // of the plane, signed along the normal
  V density_;  // of a direction, less the factor distance³
};

}  // namespace
}  // namespace hatbox::HATBOX_ISA
