#include "camera.h"

#include <cmath>
#include <numbers>

namespace wavefront {

Camera::Camera(const View& view, int width, int height) {
  using Imath::V3d;
  const double half = std::tan(view.fov_degrees * std::numbers::pi / 360);
  const double pixel = 2 * half / (view.fov_axis == 'x' ? width : height);
  const auto to_world = [&](const V3d& local) {
    V3d world;
    view.to_world.multDirMatrix(local, world);
    return V3f(world);
  };
  origin_ = V3f(V3d(0) * view.to_world);
  corner_ = to_world({pixel * width / 2, pixel * height / 2, 1});
  step_x_ = to_world({-pixel, 0, 0});  // +x of the camera is the left of the picture
  step_y_ = to_world({0, -pixel, 0});
}

}  // namespace wavefront
