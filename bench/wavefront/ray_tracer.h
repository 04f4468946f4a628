// The scene in Embree: packets of 16 rays, and what lies where a ray ends.
#pragma once

#include "scene.h"

#include <embree3/rtcore.h>

#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

namespace wavefront {

/// Where a camera ray ends.
struct SurfacePoint {
  V3f position;
  V3f normal;         // for shading
  V3f shadow_origin;  // moved off the surface, on the side of its normal, by more than rounding
  const Shape* shape;
  bool outside;  // the ray came from the side of the normal
  bool front;    // the same for the normal of the geometry: the side on which lights shine
};

class RayTracer {
 public:
  /// Keeps a reference to the scene.
  explicit RayTracer(const Scene& scene);

  /// Lanes with valid[lane] == -1 are traced, those with 0 are left alone.
  void intersect(const int* valid, RTCRayHit16& rays) const;

  /// Sets tfar of a valid lane below 0 if anything lies between its tnear and tfar.
  void occluded(const int* valid, RTCRay16& rays) const;

  /// Nothing if the ray of that lane went astray.
  std::optional<SurfacePoint> surface(const RTCRayHit16& rays, unsigned lane) const;

 private:
  struct Release {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  };
  unsigned add(const Sphere& sphere);
  unsigned add(const hatbox::Disk& disk);
  unsigned add(const Mesh& mesh);
  unsigned attach(RTCGeometry geometry);
  void throw_on_error(const char* what) const;

  std::unique_ptr<std::remove_pointer_t<RTCDevice>, Release> device_;
  std::unique_ptr<std::remove_pointer_t<RTCScene>, Release> scene_;
  std::vector<const Shape*> shapes_;  // by Embree's geometry id
};

}  // namespace wavefront
