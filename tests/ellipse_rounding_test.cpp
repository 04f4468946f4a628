// What float costs: the directions of the kernels against those of their own text in double.
#define HATBOX_ISA in_double
#include "ellipse_maps.h"

#include "ellipse_constants.h"
#include "support/conditioning.h"
#include "support/ellipses.h"
#include "support/isa_fixture.h"
#include "support/statistics.h"

#include <hatbox/hatbox.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hatbox::test {
namespace {

using reference::Vector;

template <template <class> class Map>
Vector<double> in_double_direction(const Ellipse& light, const Vec3& point, float u, float v) {
  const in_double::EllipseLight<double> known(constants_of<double>(light));
  const Map<double> map(known, point.x, point.y, point.z);
  const auto sample = map.sample(u, v);
  return {sample.direction[0], sample.direction[1], sample.direction[2]};
}

Vector<double> in_double_direction(const Ellipse& light, EllipseMap map, const Vec3& point, float u, float v) {
  return map == EllipseMap::radial ? in_double_direction<in_double::EllipseRadial>(light, point, u, v)
                                   : in_double_direction<in_double::EllipseLdRadial>(light, point, u, v);
}

class EllipseRounding : public IsaAndPoseTest {};

TEST_P(EllipseRounding, DirectionsAreThoseOfDouble) {
  constexpr double bound = 4e-6;
  constexpr std::size_t n = 10000;
  for (const double aspect : ellipse_aspects) {
    const Ellipse light = ellipse_in(pose(), aspect);
    for (const EllipseMap map : {EllipseMap::ld_radial, EllipseMap::radial}) {
      const PointArrays points = make_points(Workload::w1, pose(), n);
      const VariateArrays variates = make_variates(n);
      SampleArrays got(n);
      sample(light, map, points.view(), variates.view(), got.view());
      std::vector<double> errors;
      for (std::size_t i = 0; i < n; ++i) {
        const float u = variates.u[i], v = variates.v[i];
        double error = angle_between(got.direction(i), in_double_direction(light, map, points[i], u, v));
        if (error > bound) {
          error -= 4 * conditioning(
                           light, points[i],
                           [&](const Ellipse& l, const Vec3& p) { return in_double_direction(l, map, p, u, v); },
                           [](const auto& a, const auto& b) { return length(a - b); });
        }
        errors.push_back(std::max(error, 0.0));
      }
      report_quantiles("radians_" + std::to_string(aspect) + "_" + name(map), errors);
      EXPECT_LE(quantile(errors, 0.9999), bound) << name(map) << " aspect " << aspect;
    }
  }
}

HATBOX_FOR_EVERY_ISA_AND_POSE(EllipseRounding);

}  // namespace
}  // namespace hatbox::test
