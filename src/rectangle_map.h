// RectangleMap::spherical: uniform in solid angle, between world space and uniform_rectangle.h.
#pragma once

#include "uniform_rectangle.h"

namespace hatbox::HATBOX_ISA {
namespace {

/// A rectangle light from a shading point: what its map and its solid angle need.
template <class V>
struct RectangleView : RectangleLocal<V> {
  HATBOX_INLINE RectangleView(const RectangleLight<V>& rectangle, V px, V py, V pz)
      : RectangleLocal<V>(rectangle, px, py, pz), uniform(*this) {}

  UniformRectangle<V> uniform;
};

template <class V>
inline V solid_angle_of(const RectangleView<V>& view) {
  return view.uniform.solid_angle();
}

template <class V>
class RectangleSpherical {
 public:
  HATBOX_INLINE RectangleSpherical(const RectangleLight<V>& light, V x, V y, V z)
      : view_(light, x, y, z), density_(view_.valid, solid_angle_of(view_)) {}

  HATBOX_INLINE LightSample<V> sample(V u, V v) const;
  V pdf_of_place(const Place<V>& place) const { return density_.where(on_unit_square(place)); }
  V pdf_of_direction(const V (&direction)[3]) const { return density_.where(view_.hit(direction).inside); }
  Square<V> invert(const V (&direction)[3]) const;

 private:
  RectangleView<V> view_;
  UniformDensity<V> density_;
};

template <class V>
HATBOX_INLINE inline LightSample<V> RectangleSpherical<V>::sample(V u, V v) const {
  const RectanglePoint<V> point = view_.uniform.point(shares_of(u, view_.flip_x), shares_of(v, view_.flip_y));
  const V x = point.x.value, y = point.y.value;
  const V along[3] = {select(view_.flip_x, -x, x) * point.inverse_r, select(view_.flip_y, -y, y) * point.inverse_r,
                      view_.uniform.seen_height() * point.inverse_r};
  LightSample<V> out;
  set_direction(view_.light.axes_hi, along, out);
  out.distance = point.r * view_.scale;
  out.pdf = density_.value;
  out.place = view_.place_at(point.x.offset, point.y.offset);
  out.valid =
      density_.valid && view_.uniform.tells(point.r) && is_finite(given(u, v) + (out.distance + point.inverse_r));
  return out;
}

template <class V>
inline Square<V> RectangleSpherical<V>::invert(const V (&direction)[3]) const {
  const RectangleHit<V> hit = view_.hit(direction);
  const V u = view_.uniform.u_of(hit.x), v = view_.uniform.v_of(hit.x, hit.y);
  const Mask<V> inside = hit.inside && density_.valid;
  return {select(inside, clamp_variate(select(view_.flip_x, V(1) - u, u)), V(-1)),
          select(inside, clamp_variate(select(view_.flip_y, V(1) - v, v)), V(-1))};
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
