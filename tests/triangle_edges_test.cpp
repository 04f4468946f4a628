// Shading points next to a triangle's sides, where the solid angle hangs on how far off the side's line they are: the
// light's constants must keep all that its vertices tell.
#include "reference/vector.h"
#include "support/isa_fixture.h"
#include "support/random.h"
#include "support/statistics.h"
#include "support/workloads.h"

#include <hatbox/hatbox.h>

#include <gtest/gtest.h>

#include <cmath>

namespace hatbox::test {
namespace {

using Vector = reference::Vector<long double>;

/// By van Oosterom and Strackee 1983; the volume from differences of vertices, which do not cancel.
double exact_solid_angle(const Triangle& light, const Vec3& point) {
  const Vector p = reference::convert<long double>(point);
  const Vector a = reference::convert<long double>(light.a) - p, b = reference::convert<long double>(light.b) - p,
               c = reference::convert<long double>(light.c) - p;
  const long double volume = std::abs(dot(a, cross(b - a, c - a)));
  const long double la = length(a), lb = length(b), lc = length(c);
  return static_cast<double>(2 * std::atan2(volume, la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb));
}

Vec3 random_place(Random& random) {
  const auto coordinate = [&] { return static_cast<float>(random.uniform(-3, 3)); };
  return {coordinate(), coordinate(), coordinate()};
}

/// Above or below a place that is nearly on side i.
Vec3 next_to_side(const Triangle& light, int i, Random& random) {
  const Vec3 vertices[] = {light.a, light.b, light.c};
  const auto vertex = [&](int j) { return reference::convert<double>(vertices[j % 3]); };
  const auto from = vertex(i), along = vertex(i + 1) - from;
  const auto normal = normalize(cross(along, vertex(i + 2) - from)), aside = cross(normal, along);
  const double off = random.log_uniform(1e-5, 1e-1) * (random.unit() < 0.5 ? -1 : 1);
  const auto p = from + random.uniform(-0.2, 1.2) * along + off * aside +
                 (random.log_uniform(1e-5, 1e-1) * length(along)) * normal;
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

class TriangleEdges : public IsaTest {};

TEST_P(TriangleEdges, SolidAnglesAreThoseOfTheVerticesAsGiven) {
  Random random(17);
  std::vector<double> errors;
  while (errors.size() < 6000) {
    const Triangle light{random_place(random), random_place(random), random_place(random)};
    if (!check(light).empty()) continue;
    for (int side = 0; side < 3; ++side) {
      const Vec3 point = next_to_side(light, side, random);
      float got = -1;
      solid_angle(light, {{&point.x, 1}, {&point.y, 1}, {&point.z, 1}}, {&got, 1});
      errors.push_back(std::abs(got / exact_solid_angle(light, point) - 1));
    }
  }
  report_quantiles("relative_error", errors);
  EXPECT_LE(quantile(errors, 1), 2e-6);
}

HATBOX_FOR_EVERY_ISA(TriangleEdges);

}  // namespace
}  // namespace hatbox::test
