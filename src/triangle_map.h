// TriangleMap::spherical: uniform in the solid angle of a triangle, between world space and spherical_triangle.h.
#pragma once

#include "spherical_triangle.h"

namespace hatbox::HATBOX_ISA {
namespace {

/// A triangle light from a shading point: what its maps and its solid angle need.
template <class V>
struct TriangleView {
  HATBOX_INLINE TriangleView(const TriangleLight<V>& triangle, V x, V y, V z)
      : TriangleView(triangle, TriangleLocal<V>(triangle, x, y, z)) {}

  struct Hit {
    V direction[3];  // in the plane's axes, z towards the plane
    Mask<V> inside;
  };

  // A sliver is not much wider than the grain of float directions: its plane's axes must not add to that.
  Hit hit(const V (&direction)[3]) const {
    const auto component = [&](int i) { return dot(direction, light.axes_hi[i], light.axes_lo[i]); };
    const V n = component(2);
    Hit hit = {{component(0), component(1), select(above, -n, n)}, valid};
    hit.inside = valid && spherical.contains(hit.direction);
    return hit;
  }

  const TriangleLight<V>& light;
  Mask<V> above;
  Mask<V> valid;
  SphericalTriangle<V> spherical;
  V shrinking;

 private:
  HATBOX_INLINE TriangleView(const TriangleLight<V>& triangle, const TriangleLocal<V>& local)
      : light(triangle),
        above(local.above),
        valid(local.valid),
        spherical(local.in_plane),
        shrinking(local.shrinking) {}
};

template <class V>
inline V solid_angle_of(const TriangleView<V>& view) {
  return view.spherical.solid_angle() * view.shrinking;
}

/// Whether a place is on a triangle: a sampled one is within 16 ulp of it.
template <class V>
inline Mask<V> on_unit_triangle(const Place<V>& place) {
  const V margin = constant<V>(16 * std::numeric_limits<Scalar<V>>::epsilon());
  return (min(place.s, place.t) >= -margin) && (max(place.s, place.t) <= V(1) + margin) &&
         (place.s + place.t <= V(1) + margin);
}

template <class V>
class TriangleSpherical {
 public:
  HATBOX_INLINE TriangleSpherical(const TriangleLight<V>& light, V x, V y, V z)
      : view_(light, x, y, z), density_(view_.valid, solid_angle_of(view_)) {}

  HATBOX_INLINE LightSample<V> sample(V u, V v) const {
    const TriangleLight<V>& light = view_.light;
    const TrianglePoint<V> point = view_.spherical.sample(u, v);
    const V n = select(view_.above, -point.direction[2], point.direction[2]);
    LightSample<V> out;
    set_direction(light.axes_hi, {point.direction[0], point.direction[1], n}, out);
    out.distance = point.distance * V(light.unit);
    out.pdf = density_.value;
    out.place = point.place;
    out.valid = density_.valid && is_finite(given(u, v) + out.distance);
    return out;
  }

  V pdf_of_place(const Place<V>& place) const { return density_.where(on_unit_triangle(place)); }

  V pdf_of_direction(const V (&direction)[3]) const { return density_.where(view_.hit(direction).inside); }

  Square<V> invert(const V (&direction)[3]) const {
    const auto hit = view_.hit(direction);
    const Square<V> square = view_.spherical.invert(hit.direction);
    const Mask<V> inside = hit.inside && density_.valid;
    return {select(inside, square.u, V(-1)), select(inside, square.v, V(-1))};
  }

 private:
  TriangleView<V> view_;
  UniformDensity<V> density_;
};

}  // namespace
}  // namespace hatbox::HATBOX_ISA
