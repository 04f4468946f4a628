// What the reader makes of a scene file and the renderer works on: shapes in world space, lights, fog, the view.
#pragma once

#include <hatbox/hatbox.h>

#include <Imath/ImathColor.h>
#include <Imath/ImathMatrix.h>
#include <Imath/ImathVec.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace wavefront {

using Imath::V3f;
using Rgb = Imath::C3f;

inline V3f to_v3f(const hatbox::Vec3& v) { return {v.x, v.y, v.z}; }
inline hatbox::Vec3 to_vec3(const V3f& v) { return {v.x, v.y, v.z}; }

struct Sphere {
  V3f center;
  float radius;
};

struct Mesh {
  std::vector<V3f> positions;
  std::vector<V3f> normals;  // a unit vector a position, or empty: flat triangles
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

using Geometry = std::variant<Sphere, hatbox::Disk, hatbox::Ellipse, Mesh>;

/// A Lambertian surface. Flat ones scatter on the side of their normal only.
struct Shape {
  Geometry geometry;
  Rgb reflectance;
  std::optional<std::size_t> emitter;  // index into Scene::emitters
};

struct MeshLight {
  std::vector<hatbox::Triangle> triangles;  // at least one; valid, and turned so that the cosine is > 0 in front
  std::vector<std::uint32_t> of_mesh;       // which of the mesh's triangles each is
};

using Light = std::variant<hatbox::Disk, hatbox::Ellipse, hatbox::Rectangle, MeshLight>;

struct Emitter {
  Light light;
  Rgb radiance;
  bool double_sided;
};

/// A homogeneous medium, which fills all of space or a body: the unit ball or the cube [-1, 1]³, transformed.
struct Medium {
  struct Body {
    bool ball;
    Imath::M44d to_local;
  };

  Rgb sigma_s, sigma_a;  // scattering and absorption, per unit of length
  float g = 0;           // mean cosine of the phase function (Henyey and Greenstein 1941); 0: isotropic
  std::optional<Body> body;
};

/// A perspective camera, which looks along +z of its own space with +x to the left of the picture and +y up.
struct View {
  Imath::M44d to_world;  // Imath's convention: row vectors, p' = p · M
  double fov_degrees = 90;
  char fov_axis = 'x';
};

struct Scene {
  std::vector<Shape> shapes;
  std::vector<Emitter> emitters;
  std::optional<Medium> medium;
  bool hide_emitters = false;  // then a light's own shape stops neither camera rays nor shadow rays
  View view;
  int width = 768;
  int height = 576;
  std::uint32_t samples_per_pixel = 4;
  std::vector<std::string> ignored;  // properties of the file that mean nothing here, "sampling (line 69)"
};

/// What is wrong with a scene file, in one line with file, line and element.
class SceneError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace wavefront
