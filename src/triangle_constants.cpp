#include "light_constants.h"
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

double longest_side(const Triangle& light) {
  return std::max({length(difference(light.b, light.a)), length(difference(light.c, light.a)),
                   length(difference(light.c, light.b))});
}

}  // namespace

double thinness(const Triangle& light) {
  const double longest = longest_side(light);
  if (longest == 0) return 0;
  return length(accurate_cross(scaled(1 / longest, difference(light.b, light.a)),
                               scaled(1 / longest, difference(light.c, light.a))));
}

template <class T>
TriangleConstantsOf<T> constants_of(const Triangle& light) {
  const double unit = std::exp2(std::floor(std::log2(longest_side(light))));
  const Double3 ab = scaled(1 / unit, difference(light.b, light.a)),
                ac = scaled(1 / unit, difference(light.c, light.a));
  const Double3 normal = accurate_cross(ab, ac);
  const double doubled_area = length(normal), ab_length = length(ab);
  const Double3 x = divided(ab, ab_length), z = divided(normal, doubled_area), y = cross(z, x);
  const double axes[3][3] = {{x.x, x.y, x.z}, {y.x, y.y, y.z}, {z.x, z.y, z.z}};
  const double c[2] = {dot(ac, x), doubled_area / ab_length};
  const double sides[3][2] = {{c[0] - ab_length, c[1]}, {-c[0], -c[1]}, {ab_length, 0}};

  TriangleConstantsOf<T> constants = {};
  constants.vertex[0] = light.a.x;
  constants.vertex[1] = light.a.y;
  constants.vertex[2] = light.a.z;
  for (int row = 0; row < 3; ++row) {
    for (int i = 0; i < 3; ++i) {
      constants.axes[row][i] = static_cast<T>(axes[row][i]);
      split(axes[row][i] / unit, constants.axes_hi[row][i], constants.axes_lo[row][i]);
    }
    for (int i = 0; i < 2; ++i) split(sides[row][i], constants.side_hi[row][i], constants.side_lo[row][i]);
    constants.length[row] = static_cast<T>(std::hypot(sides[row][0], sides[row][1]));
  }
  const Double3 edges[2] = {ab, ac};
  for (int i = 0; i < 2; ++i) {
    constants.edges[i][0] = static_cast<T>(edges[i].x);
    constants.edges[i][1] = static_cast<T>(edges[i].y);
    constants.edges[i][2] = static_cast<T>(edges[i].z);
  }
  constants.doubled_area = static_cast<T>(doubled_area);
  constants.inverse_area = static_cast<T>(2 / doubled_area);
  constants.unit = static_cast<T>(unit);
  constants.inverse_unit = static_cast<T>(1 / unit);
  return constants;
}

template TriangleConstantsOf<float> constants_of(const Triangle& light);
template TriangleConstantsOf<double> constants_of(const Triangle& light);

}  // namespace hatbox
