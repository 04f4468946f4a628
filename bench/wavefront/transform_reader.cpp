#include "transform_reader.h"

#include <cmath>
#include <numbers>

namespace wavefront {
namespace {

using Imath::M44d;
using Imath::V3d;

V3d to_vector(const std::vector<double>& numbers) { return {numbers[0], numbers[1], numbers[2]}; }

M44d translation(const XmlElement& step) {
  return M44d().setTranslation(V3d(step.number("x", 0), step.number("y", 0), step.number("z", 0)));
}

M44d scaling(const XmlElement& step) {
  const double uniform = step.number("value", 1);
  return M44d().setScale(V3d(step.number("x", uniform), step.number("y", uniform), step.number("z", uniform)));
}

M44d rotation(const XmlElement& step) {
  const V3d axis(step.number("x", 0), step.number("y", 0), step.number("z", 0));
  if (axis.length() == 0) step.fail("the axis is zero");
  return M44d().setAxisAngle(axis.normalized(), step.number("angle", 0) * std::numbers::pi / 180);
}

/// Camera space as Mitsuba has it: +z forward and +x to the *left*, which keeps it right-handed.
M44d look_at(const XmlElement& step) {
  const V3d origin = to_vector(step.numbers("origin", 3));
  const V3d forward = (to_vector(step.numbers("target", 3)) - origin).normalized();
  const V3d up = step.has("up") ? to_vector(step.numbers("up", 3)) : V3d(0, 1, 0);
  const V3d left = up.cross(forward).normalized();
  if (left.length() == 0) step.fail("'origin', 'target' and 'up' do not span a view");
  const V3d above = forward.cross(left);
  return {left.x,    left.y,    left.z,    0, above.x,  above.y,  above.z,  0,
          forward.x, forward.y, forward.z, 0, origin.x, origin.y, origin.z, 1};
}

/// Written row by row for column vectors, so transposed for Imath.
M44d matrix(const XmlElement& step) {
  const auto values = step.numbers("value", 16);
  M44d result;
  for (int i = 0; i < 16; ++i) result[i % 4][i / 4] = values[static_cast<std::size_t>(i)];
  return result;
}

}  // namespace

Imath::M44d read_transform(const XmlElement& transform) {
  M44d result;
  for (const XmlElement& step : transform.children({"translate", "rotate", "scale", "lookAt", "lookat", "matrix"})) {
    const std::string_view tag = step.tag();
    if (tag == "translate") {
      result *= translation(step);
    } else if (tag == "rotate") {
      result *= rotation(step);
    } else if (tag == "scale") {
      result *= scaling(step);
    } else if (tag == "matrix") {
      result *= matrix(step);
    } else if (tag == "lookAt" || tag == "lookat") {
      result *= look_at(step);
    } else {
      step.fail("is no step of a transform");
    }
  }
  if (std::abs(result.determinant()) < 1e-300) transform.fail("the transform flattens space");
  return result;
}

}  // namespace wavefront
