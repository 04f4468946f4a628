// A triangle as a shading point sees it: its vertices in its own plane, from the foot of the shading point, and what
// each of its sides spans with the shading point.
//
// All that follows is made of heights, lengths and the cross products of neighbouring vertices: twice the area of the
// triangle of the foot and a side, which cancels where the foot is near the side's line. Vertices are carried as
// unevaluated sums until these products are formed, so that they keep what the inputs determine.
#pragma once

#include "compensated.h"
#include "light_sample.h"
#include "triangle_light.h"

namespace hatbox::HATBOX_ISA {
namespace {

/// Any triangle in a plane that is not the shading point's; the z axis points from the shading point to the plane.
/// Vertices go counterclockwise about it. Side i lies opposite vertex i and runs from vertex i + 1 to i + 2 (mod 3).
template <class V>
struct PlaneTriangle {
  V x[3], y[3];  // vertices
  V z;           // the plane's, > 0
  V side_x[3], side_y[3];
  V length[3];  // of the sides
  V cross[3];   // of the vertices a side runs from and to
  V doubled_area;
};

// Heights above the plane are taken to be at least this share of the triangle's size: less would overflow quotients.
// Beside the light its solid angle is proportional to the height there, and above it is 2π.
inline constexpr double least_triangle_height = 0x1p-90;

/// √(x² + y² + z²), also where the squares would underflow.
template <class V>
HATBOX_INLINE inline V length_of_small(V x, V y, V z) {
  const Mask<V> tiny = max(max(abs(x), abs(y)), abs(z)) < constant<V>(0x1p-40);
  const V up = select(tiny, constant<V>(0x1p64), V(1)), down = select(tiny, constant<V>(0x1p-64), V(1));
  const V scaled_x = x * up, scaled_y = y * up, scaled_z = z * up;
  return sqrt(fma(scaled_x, scaled_x, fma(scaled_y, scaled_y, scaled_z * scaled_z))) * down;
}

/// p · s − q · r, in twice the precision and then rounded (Kahan's difference of products, with the low parts).
template <class V>
HATBOX_INLINE inline V determinant(const Pair<V>& p, const Pair<V>& q, const Pair<V>& r, const Pair<V>& s) {
  const Pair<V> qr = two_product(q.high, r.high);
  const V high = fma(p.high, s.high, -qr.high) - qr.low;
  return high + (fma(p.high, s.low, p.low * s.high) - fma(q.high, r.low, q.low * r.high));
}

template <class V>
struct TriangleLocal {
  HATBOX_INLINE TriangleLocal(const TriangleLight<V>& light, V px, V py, V pz) {
    const Pair<V> l[3] = {two_sum(V(light.vertex[0]), -px), two_sum(V(light.vertex[1]), -py),
                          two_sum(V(light.vertex[2]), -pz)};
    const auto along_axis = [&](int i) {
      const Pair<V> d = dot_pair(l, light.axes_hi[i], light.axes_lo[i]);
      return two_sum(d.high * V(light.inverse_unit), d.low * V(light.inverse_unit));
    };
    const Pair<V>&base = light.base, &apex_x = light.apex_x, &apex_y = light.apex_y, &from_b = light.from_b;
    const auto minus = [](const Pair<V>& p) { return Pair<V>{-p.high, -p.low}; };
    const Pair<V> a_x = along_axis(0), a_y = along_axis(1), n = along_axis(2);
    const Pair<V> b_x = sum(a_x, base), c_x = sum(a_x, apex_x), c_y = sum(a_y, apex_y);
    in_plane.x[0] = a_x.high;
    in_plane.x[1] = b_x.high;
    in_plane.x[2] = c_x.high;
    in_plane.y[0] = in_plane.y[1] = a_y.high;  // the x axis lies along side 2
    in_plane.y[2] = c_y.high;
    in_plane.cross[0] = determinant(b_x, a_y, from_b, apex_y);
    in_plane.cross[1] = determinant(a_x, a_y, minus(apex_x), minus(apex_y));
    in_plane.cross[2] = -(a_y.high * base.high);
    in_plane.side_x[0] = from_b.high;
    in_plane.side_x[1] = -apex_x.high;
    in_plane.side_x[2] = base.high;
    in_plane.side_y[0] = apex_y.high;
    in_plane.side_y[1] = -apex_y.high;
    in_plane.side_y[2] = V(0);
    for (int i = 0; i < 3; ++i) in_plane.length[i] = V(light.side_length[i]);
    in_plane.doubled_area = V(light.doubled_area);
    const V height = abs(n.high);
    in_plane.z = max(height, constant<V>(least_triangle_height));
    const Mask<V> beside = min(min(in_plane.cross[0], in_plane.cross[1]), in_plane.cross[2]) < V(0);
    shrinking = select(beside, min(height * constant<V>(1 / least_triangle_height), V(1)), V(1));
    above = n.high < V(0);
    valid = (height > V(0)) && is_finite(a_x.high + a_y.high + n.high);
  }

  PlaneTriangle<V> in_plane;
  V shrinking;    // how much smaller the solid angle is than that seen from in_plane.z
  Mask<V> above;  // the shading point lies on the side of the normal
  Mask<V> valid;  // false in the light's plane and for non-finite points; the rest is then of no use
};

}  // namespace
}  // namespace hatbox::HATBOX_ISA
