#include "ellipse_constants.h"

#include "light_frame.h"

#include <cmath>
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

}  // namespace

template <class T>
EllipseConstantsOf<T> constants_of(const Ellipse& light) {
  const Frame frame = frame_of(light);
  const double longer = frame.longer.length, shorter = frame.shorter.length;
  const double unit = power_of_two_below(longer);
  const double ratio = shorter / longer;  // 1 for a circle

  EllipseConstantsOf<T> constants = {};
  set_vector(constants.center, in_double(light.center));
  set_vector(constants.axes[0], frame.longer.unit);
  set_vector(constants.axes[1], frame.shorter.unit);
  set_split(constants.axes[2], constants.normal_lo, frame.normal);
  constants.radius = static_cast<T>(longer);
  constants.inverse_unit = static_cast<T>(1 / unit);
  constants.per_unit = static_cast<T>(unit / longer);
  constants.shorter_per_unit = static_cast<T>(unit / shorter);
  constants.ratio = static_cast<T>(ratio);
  constants.inverse_ratio = static_cast<T>(1 / ratio);
  constants.flattening = static_cast<T>((1 - ratio) * (1 + ratio));
  constants.swapped = frame.swapped ? 1 : 0;
  return constants;
}

template EllipseConstantsOf<float> constants_of(const Ellipse& light);
template EllipseConstantsOf<double> constants_of(const Ellipse& light);

}  // namespace hatbox
