// The scene in Embree: packets of 16 rays, and what lies where a ray ends. Lights are in a scene of their own as well,
// so that one finds them whether they stop rays or not.
#pragma once

#include "scene.h"

#include <embree3/rtcore.h>

#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

namespace wavefront {

constexpr float just_before_the_light = 1 - 0x1p-13f;  // where a ray to it ends, as a visible one would shadow itself

inline void set_origin(RTCRay16& rays, unsigned lane, const V3f& origin) {
  rays.org_x[lane] = origin.x;
  rays.org_y[lane] = origin.y;
  rays.org_z[lane] = origin.z;
}

/// From the origin on.
inline void set_direction(RTCRay16& rays, unsigned lane, const V3f& direction, float distance) {
  rays.dir_x[lane] = direction.x;
  rays.dir_y[lane] = direction.y;
  rays.dir_z[lane] = direction.z;
  rays.tnear[lane] = 0;
  rays.tfar[lane] = distance;
  rays.mask[lane] = ~0u;
}

inline void expect_hit(RTCHit16& hits, unsigned lane) {
  hits.geomID[lane] = hits.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
}

/// Where a camera ray ends.
struct SurfacePoint {
  V3f position;
  V3f normal;         // for shading
  V3f shadow_origin;  // moved off the surface, on the side of its normal, by more than rounding
  const Shape* shape;
  std::uint32_t triangle;  // of a mesh
  bool outside;            // the ray came from the side of the normal
  bool front;              // the same for the normal of the geometry: the side on which lights shine
};

class RayTracer {
 public:
  /// Keeps a reference to the scene.
  explicit RayTracer(const Scene& scene);

  /// Lanes with valid[lane] == -1 are traced, those with 0 are left alone.
  void intersect(const int* valid, RTCRayHit16& rays) const;

  /// Nothing but the lights' shapes.
  void intersect_lights(const int* valid, RTCRayHit16& rays) const;

  /// Sets tfar of a valid lane below 0 if anything lies between its tnear and tfar.
  void occluded(const int* valid, RTCRay16& rays) const;

  /// What the ray of that lane hit; null if nothing.
  const Shape* shape_of(const RTCRayHit16& rays, unsigned lane) const;

  /// Nothing if the ray of that lane went astray.
  std::optional<SurfacePoint> surface(const RTCRayHit16& rays, unsigned lane) const;

 private:
  struct Release {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  };
  using EmbreeScene = std::unique_ptr<std::remove_pointer_t<RTCScene>, Release>;

  RTCGeometry make(const Sphere& sphere);
  RTCGeometry make(const hatbox::Disk& disk);
  RTCGeometry make(const hatbox::Ellipse& ellipse);
  RTCGeometry make(const Mesh& mesh);
  void add(const Shape& shape, bool stops_rays);
  void throw_on_error(const char* what) const;

  std::unique_ptr<std::remove_pointer_t<RTCDevice>, Release> device_;
  EmbreeScene unit_disk_, scene_, lights_;
  std::vector<const Shape*> shapes_;  // by Embree's geometry id, which is the same in both scenes
};

}  // namespace wavefront
