#include "light_constants.h"

#include "light_frame.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace hatbox {
namespace {

/// The semi-axes of a light, by length, and its normal.
struct Frame {
  Extent longer, shorter;
  Double3 normal;
  bool swapped;  // semi_axis_v is the longer one
};

Frame frame_of(const Ellipse& light) {
  Extent u = extent_of(in_double(light.semi_axis_u)), v = extent_of(in_double(light.semi_axis_v));
  // Rounded coordinates make the axes of a circle differ by an ulp or two. Taken for an ellipse's they would turn the
  // maps by any angle.
  constexpr double rounding = 0x1p-22;
  if (std::abs(u.length - v.length) <= rounding * u.length) v.length = u.length;
  const Double3 normal = extent_of(cross(u.unit, v.unit)).unit;
  const bool swapped = v.length > u.length;
  if (swapped) std::swap(u, v);
  // Only the shorter one is turned: the longer one's end would move by more than the shorter's length.
  v.unit = cross(normal, scaled(swapped ? -1 : 1, u.unit));
  return {u, v, normal, swapped};
}

/// `size` in units of the longer semi-axis.
template <class T>
void set_span(EllipseConstantsOf<T>& constants, int index, const Double3& unit, double size) {
  const double axis[3] = {unit.x, unit.y, unit.z};
  for (int i = 0; i < 3; ++i) {
    constants.spans[index][i] = static_cast<T>(size * axis[i]);
    constants.inverse_spans[index][i] = static_cast<T>(axis[i] / size);
  }
}

}  // namespace

template <class T>
EllipseConstantsOf<T> constants_of(const Ellipse& light) {
  const Frame frame = frame_of(light);
  const double inverse_radius = 1 / frame.longer.length;
  const double ratio = frame.shorter.length / frame.longer.length;  // 1 for a circle

  EllipseConstantsOf<T> constants = {};
  set_center(constants, light.center);
  set_axis(constants, 0, frame.longer.unit, inverse_radius);
  set_axis(constants, 1, frame.shorter.unit, 1 / frame.shorter.length);
  set_axis(constants, 2, frame.normal, inverse_radius);
  set_span(constants, frame.swapped ? 1 : 0, frame.longer.unit, 1);
  set_span(constants, frame.swapped ? 0 : 1, frame.shorter.unit, ratio);
  constants.ratio = static_cast<T>(ratio);
  constants.ratio2 = static_cast<T>(ratio * ratio);
  constants.inverse_ratio = static_cast<T>(1 / ratio);
  const double flattening = (1 - ratio) * (1 + ratio);
  constants.flattening = static_cast<T>(flattening);
  constants.flattening2 = static_cast<T>(flattening * flattening);
  constants.area = static_cast<T>(std::numbers::pi * ratio);
  constants.radius = static_cast<T>(frame.longer.length);
  constants.inverse_radius = static_cast<T>(inverse_radius);
  constants.swapped = frame.swapped;
  return constants;
}

template EllipseConstantsOf<float> constants_of(const Ellipse& light);
template EllipseConstantsOf<double> constants_of(const Ellipse& light);

}  // namespace hatbox
