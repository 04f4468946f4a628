// A pinhole camera.
#pragma once

#include "scene.h"

namespace wavefront {

class Camera {
 public:
  Camera(const View& view, int width, int height);

  const V3f& origin() const { return origin_; }

  /// Unit direction through a place in the picture, in pixels from its upper left corner.
  V3f direction(float x, float y) const { return (corner_ + x * step_x_ + y * step_y_).normalized(); }

 private:
  V3f origin_;
  V3f corner_, step_x_, step_y_;  // a point at distance one in front of the camera is linear in the pixel
};

}  // namespace wavefront
