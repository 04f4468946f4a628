#include "triangle_constants.h"
#include "light_frame.h"

#include <algorithm>
#include <cmath>

namespace hatbox {
namespace {

Double3 difference(const Vec3& to, const Vec3& from) {
  return {double{to.x} - double{from.x}, double{to.y} - double{from.y}, double{to.z} - double{from.z}};
}

double length(const Double3& v) { return std::sqrt(dot(v, v)); }

/// a·b − c·d without cancellation (Kahan): the normal of a sliver is a small difference of large products.
double difference_of_products(double a, double b, double c, double d) {
  const double cd = c * d;
  return std::fma(a, b, -cd) - std::fma(c, d, -cd);
}

Double3 accurate_cross(const Double3& p, const Double3& q) {
  return {difference_of_products(p.y, q.z, p.z, q.y), difference_of_products(p.z, q.x, p.x, q.z),
          difference_of_products(p.x, q.y, p.y, q.x)};
}

}  // namespace

double longest_side(const Triangle& light) {
  return std::max({length(difference(light.b, light.a)), length(difference(light.c, light.a)),
                   length(difference(light.c, light.b))});
}

double thinness(const Triangle& light) {
  const double longest = longest_side(light);
  if (longest == 0) return 0;
  return length(accurate_cross(scaled(1 / longest, difference(light.b, light.a)),
                               scaled(1 / longest, difference(light.c, light.a))));
}

template <class T>
TriangleConstantsOf<T> constants_of(const Triangle& light) {
  const double unit = power_of_two_below(longest_side(light));
  const Double3 ab = scaled(1 / unit, difference(light.b, light.a)),
                ac = scaled(1 / unit, difference(light.c, light.a));
  const Double3 normal = accurate_cross(ab, ac);
  const double doubled_area = length(normal), base = length(ab);
  const Double3 x = divided(ab, base), z = divided(normal, doubled_area), y = cross(z, x);

  TriangleConstantsOf<T> constants = {};
  set_vector(constants.vertex, in_double(light.a));
  set_split(constants.axes_hi[0], constants.x_lo, x);
  set_vector(constants.axes_hi[1], y);
  set_split(constants.axes_hi[2], constants.z_lo, z);
  split(base * unit, constants.base_hi, constants.base_lo);
  split(dot(ac, x) / base, constants.apex_hi[0], constants.apex_lo[0]);
  split(doubled_area / base / base, constants.apex_hi[1], constants.apex_lo[1]);
  return constants;
}

template TriangleConstantsOf<float> constants_of(const Triangle& light);
template TriangleConstantsOf<double> constants_of(const Triangle& light);

}  // namespace hatbox
