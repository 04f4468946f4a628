#include "ray_tracer.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace wavefront {
namespace {

/// Copies an array into a buffer that Embree owns, aligns and pads.
template <class T>
void set_buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format, const std::vector<T>& data) {
  void* buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(T), data.size());
  if (!buffer) throw std::runtime_error("Embree has no memory for the scene");
  std::copy(data.begin(), data.end(), static_cast<T*>(buffer));
}

/// The hit itself is only as good as `distance` in float; what the shape says about its surface is better.
V3f snap_to_plane(const V3f& hit, const V3f& on_plane, const V3f& normal) {
  return hit - normal * normal.dot(hit - on_plane);
}

V3f mesh_normal(const Mesh& mesh, unsigned triangle, float u, float v, const V3f& flat) {
  if (mesh.normals.empty()) return flat;
  const auto& [a, b, c] = mesh.triangles[triangle];
  return (mesh.normals[a] * (1 - u - v) + mesh.normals[b] * u + mesh.normals[c] * v).normalized();
}

}  // namespace

RayTracer::RayTracer(const Scene& scene) : device_(rtcNewDevice(nullptr)) {
  throw_on_error("cannot start Embree");
  for (EmbreeScene* embree_scene : {&unit_disk_, &scene_, &lights_}) embree_scene->reset(rtcNewScene(device_.get()));
  const RTCGeometry disk = make(hatbox::Disk{{0, 0, 0}, {0, 0, 1}, 1});
  rtcCommitGeometry(disk);
  rtcAttachGeometry(unit_disk_.get(), disk);
  rtcReleaseGeometry(disk);
  rtcCommitScene(unit_disk_.get());
  for (const Shape& shape : scene.shapes) add(shape, !(shape.emitter && scene.hide_emitters));
  rtcCommitScene(scene_.get());
  rtcCommitScene(lights_.get());
  throw_on_error("Embree cannot build the scene");
}

void RayTracer::add(const Shape& shape, bool stops_rays) {
  const RTCGeometry geometry = std::visit([&](const auto& g) { return make(g); }, shape.geometry);
  rtcCommitGeometry(geometry);
  const auto id = static_cast<unsigned>(shapes_.size());
  if (stops_rays) rtcAttachGeometryByID(scene_.get(), geometry, id);
  if (shape.emitter) rtcAttachGeometryByID(lights_.get(), geometry, id);
  rtcReleaseGeometry(geometry);
  shapes_.push_back(&shape);
}

void RayTracer::throw_on_error(const char* what) const {
  const RTCError error = rtcGetDeviceError(device_.get());
  if (error != RTC_ERROR_NONE) throw std::runtime_error(std::string(what) + " (error " + std::to_string(error) + ")");
}

RTCGeometry RayTracer::make(const Sphere& sphere) {
  const RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_SPHERE_POINT);
  const std::vector<Imath::V4f> place = {{sphere.center.x, sphere.center.y, sphere.center.z, sphere.radius}};
  set_buffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, place);
  return geometry;
}

RTCGeometry RayTracer::make(const hatbox::Disk& disk) {
  const RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_ORIENTED_DISC_POINT);
  const std::vector<Imath::V4f> place = {{disk.center.x, disk.center.y, disk.center.z, disk.radius}};
  set_buffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, place);
  set_buffer(geometry, RTC_BUFFER_TYPE_NORMAL, RTC_FORMAT_FLOAT3, std::vector<V3f>{to_v3f(disk.normal)});
  return geometry;
}

/// Embree has round disks only: an instance of one, transformed.
RTCGeometry RayTracer::make(const hatbox::Ellipse& ellipse) {
  const RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_INSTANCE);
  rtcSetGeometryInstancedScene(geometry, unit_disk_.get());
  const V3f u = to_v3f(ellipse.semi_axis_u), v = to_v3f(ellipse.semi_axis_v), n = u.cross(v).normalized();
  const float columns[] = {
      u.x, u.y, u.z, v.x, v.y, v.z, n.x, n.y, n.z, ellipse.center.x, ellipse.center.y, ellipse.center.z};
  rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns);
  return geometry;
}

RTCGeometry RayTracer::make(const Mesh& mesh) {
  const RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  set_buffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, mesh.positions);
  set_buffer(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, mesh.triangles);
  return geometry;
}

void RayTracer::intersect(const int* valid, RTCRayHit16& rays) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect16(valid, scene_.get(), &context, &rays);
}

void RayTracer::intersect_lights(const int* valid, RTCRayHit16& rays) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect16(valid, lights_.get(), &context, &rays);
}

void RayTracer::occluded(const int* valid, RTCRay16& rays) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded16(valid, scene_.get(), &context, &rays);
}

const Shape* RayTracer::shape_of(const RTCRayHit16& rays, unsigned lane) const {
  if (rays.hit.geomID[lane] == RTC_INVALID_GEOMETRY_ID) return nullptr;
  const unsigned instance = rays.hit.instID[0][lane];
  return shapes_[instance == RTC_INVALID_GEOMETRY_ID ? rays.hit.geomID[lane] : instance];
}

std::optional<SurfacePoint> RayTracer::surface(const RTCRayHit16& rays, unsigned lane) const {
  const RTCRay16& ray = rays.ray;
  const RTCHit16& hit = rays.hit;
  const Shape* const hit_shape = shape_of(rays, lane);
  if (!hit_shape) return {};

  const V3f origin(ray.org_x[lane], ray.org_y[lane], ray.org_z[lane]);
  const V3f direction(ray.dir_x[lane], ray.dir_y[lane], ray.dir_z[lane]);
  const V3f place = origin + ray.tfar[lane] * direction;
  V3f flat = V3f(hit.Ng_x[lane], hit.Ng_y[lane], hit.Ng_z[lane]).normalized();
  const Shape& shape = *hit_shape;
  SurfacePoint point{place, flat, place, &shape, hit.primID[lane], true, true};
  if (const auto* sphere = std::get_if<Sphere>(&shape.geometry)) {
    point.normal = flat = (place - sphere->center).normalized();
    point.position = sphere->center + sphere->radius * flat;
  } else if (const auto* disk = std::get_if<hatbox::Disk>(&shape.geometry)) {
    point.normal = flat = to_v3f(disk->normal);
    point.position = snap_to_plane(place, to_v3f(disk->center), flat);
  } else if (const auto* ellipse = std::get_if<hatbox::Ellipse>(&shape.geometry)) {
    point.normal = flat = to_v3f(ellipse->semi_axis_u).cross(to_v3f(ellipse->semi_axis_v)).normalized();
    point.position = snap_to_plane(place, to_v3f(ellipse->center), flat);
  } else if (const auto* mesh = std::get_if<Mesh>(&shape.geometry)) {
    point.normal = mesh_normal(*mesh, hit.primID[lane], hit.u[lane], hit.v[lane], flat);
    if (flat.dot(point.normal) < 0) flat = -flat;  // a mirroring transform turns the triangles, not the normals
    point.position = snap_to_plane(place, mesh->positions[mesh->triangles[hit.primID[lane]][0]], flat);
  }
  // The length of the camera ray counts as well, because its rounding does.
  const float size = std::max({std::abs(place.x), std::abs(place.y), std::abs(place.z), ray.tfar[lane]});
  point.shadow_origin = point.position + flat * (0x1p-17f * size);
  point.outside = point.normal.dot(direction) < 0;
  point.front = flat.dot(direction) < 0;
  return point;
}

}  // namespace wavefront
