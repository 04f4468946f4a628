// RectangleMap::two_triangles: uniform in solid angle, by way of the two spherical triangles that a diagonal makes of
// the rectangle as it is seen; what Ureña et al. 2013 (UFK13), §6, compare their map with. One of the two is chosen in
// proportion to its solid angle and sampled by Arvo's map (spherical_triangle.h).
//
// Choosing by u leaves of it a variate u' of the chosen one: with areas Ω₁ and Ω₂, and Ω = Ω₁ + Ω₂,
//   first:  u' = uΩ/Ω₁, 1 − u' = d/Ω₁;  second:  u' = −d/Ω₂, 1 − u' = (1 − u)Ω/Ω₂;  d = Ω₁ − uΩ = (1 − u)Ω − Ω₂.
// d cancels at the seam, where it is off by an ulp of the area it is made of: the smaller one is. Next to the light
// nearly all of it may be one triangle, and a 1e-5th of that turn a direction by a radian (6e-5 of a diameter if not).
#pragma once

#include "either_triangle.h"
#include "rectangle_local.h"

namespace hatbox::HATBOX_ISA {
namespace {

/// The two halves of a rectangle in its own plane: the first has the corners c, c + u, c + u + v of the rectangle, the
/// second c, c + u + v, c + v.
template <class V>
struct RectangleHalves {
  HATBOX_INLINE RectangleHalves(const RectangleLight<V>& light, V px, V py, V pz) {
    const Pair<V> l[3] = {two_sum(V(light.corner[0]), -px), two_sum(V(light.corner[1]), -py),
                          two_sum(V(light.corner[2]), -pz)};
    const auto in_units = [&](const Pair<V>& p) {
      return two_sum(p.high * V(light.inverse_unit), p.low * V(light.inverse_unit));
    };
    const auto along_axis = [&](int i) { return in_units(dot_pair(l, light.axes_hi[i], light.axes_lo[i])); };
    const auto edge = [&](int i) { return Pair<V>{V(light.length[i]) * V(light.inverse_unit), V(0)}; };
    const Pair<V> x = along_axis(0), y = along_axis(1), n = along_axis(2), u = edge(0), v = edge(1);
    const V x0 = x.high, x1 = sum(x, u).high, y0 = y.high, y1 = sum(y, v).high;
    const V diagonal = length_of_small(u.high, v.high), across_diagonal = determinant(x, y, u, v);
    const V height = abs(n.high), area = u.high * v.high, none = V(0);
    const V z = max(height, constant<V>(least_triangle_height));
    first = {{x0, x1, x1},
             {y0, y0, y1},
             z,
             {none, -u.high, u.high},
             {v.high, -v.high, none},
             {v.high, diagonal, u.high},
             {x1 * v.high, -across_diagonal, -(y0 * u.high)},
             area};
    second = {{x0, x1, x0},
              {y0, y1, y1},
              z,
              {-u.high, none, u.high},
              {none, -v.high, v.high},
              {u.high, v.high, diagonal},
              {y1 * u.high, -(x0 * v.high), across_diagonal},
              area};
    above = n.high < V(0);
    const Mask<V> beside = (max(x0, y0) > V(0)) || (min(x1, y1) < V(0));
    shrinking = select(beside, min(height * constant<V>(1 / least_triangle_height), V(1)), V(1));
    valid = (height > V(0)) && is_finite(x.high + y.high + n.high);
  }

  PlaneTriangle<V> first, second;
  V shrinking;    // how much smaller the solid angle is than that seen from the height of the triangles
  Mask<V> above;  // the shading point lies on the side of the normal
  Mask<V> valid;  // false in the light's plane and for non-finite points; the rest is then of no use
};

template <class V>
class RectangleTwoTriangles {
 public:
  HATBOX_INLINE RectangleTwoTriangles(const RectangleLight<V>& light, V x, V y, V z)
      : RectangleTwoTriangles(light, RectangleHalves<V>(light, x, y, z)) {}

  HATBOX_INLINE LightSample<V> sample(V u, V v) const {
    const Choice choice = choose(clamp_variate(u));
    const TrianglePoint<V> point = first_.either(choice.first, second_).sample(choice.u, v);
    const V n = select(above_, -point.direction[2], point.direction[2]);
    LightSample<V> out;
    set_direction(light_.axes_hi, {point.direction[0], point.direction[1], n}, out);
    out.distance = point.distance * V(light_.unit);
    out.pdf = density_.value;
    const V both = min(point.place.s + point.place.t, V(1));
    out.place = {select(choice.first, both, point.place.s), select(choice.first, point.place.t, both)};
    out.valid = density_.valid && is_finite(given(u, v) + out.distance);
    return out;
  }

  V pdf_of_place(const Place<V>& place) const { return density_.where(on_unit_square(place)); }

  V pdf_of_direction(const V (&direction)[3]) const { return density_.where(hit(direction).inside); }

  Square<V> invert(const V (&direction)[3]) const {
    const Hit seen = hit(direction);
    const Mask<V> in_first = first_.inwards(1, seen.direction) >= V(0);  // of its side along the diagonal
    const Square<V> square = first_.either(in_first, second_).invert(seen.direction);
    const V before = select(in_first, V(0), first_.solid_angle());
    const V area = select(in_first, first_.solid_angle(), second_.solid_angle());
    const V u = fma(square.u, area, before) / both_;
    return {select(seen.inside, clamp_variate(u), V(-1)), select(seen.inside, square.v, V(-1))};
  }

 private:
  /// Which triangle a sample lies in, and the variate that is left for it.
  struct Choice {
    Mask<V> first;
    Shares<V> u;
  };
  struct Hit {
    V direction[3];  // in the plane's axes, z towards the plane
    Mask<V> inside;
  };

  HATBOX_INLINE RectangleTwoTriangles(const RectangleLight<V>& light, const RectangleHalves<V>& halves)
      : light_(light),
        above_(halves.above),
        first_(halves.first),
        second_(halves.second),
        both_(first_.solid_angle() + second_.solid_angle()),
        density_(halves.valid, both_ * halves.shrinking) {}

  HATBOX_INLINE Choice choose(V u) const {
    const V of_first = first_.solid_angle(), of_second = second_.solid_angle();
    const V before = u * both_, behind = (V(1) - u) * both_;
    const V to_seam = select(of_first < of_second, of_first - before, behind - of_second);
    const Mask<V> first = to_seam > V(0);
    const V inverse = select(first, first_.inverse_solid_angle(), second_.inverse_solid_angle());
    return {first, {select(first, before, -to_seam) * inverse, select(first, to_seam, behind) * inverse}};
  }

  Hit hit(const V (&direction)[3]) const {
    const auto component = [&](int i) { return dot(direction, light_.axes_hi[i], light_.axes_lo[i]); };
    const V n = component(2);
    Hit hit = {{component(0), component(1), select(above_, -n, n)}, density_.valid};
    hit.inside = density_.valid && (first_.contains(hit.direction) || second_.contains(hit.direction));
    return hit;
  }

  const RectangleLight<V>& light_;
  Mask<V> above_;
  SphericalTriangle<V> first_, second_;
  V both_;  // of their solid angles
  UniformDensity<V> density_;
};

}  // namespace
}  // namespace hatbox::HATBOX_ISA
