#include "shape_reader.h"

#include "mesh.h"

#include <array>
#include <cmath>

namespace wavefront {
namespace {

using Imath::M44d;
using Imath::V3d;

V3d transform_vector(const V3d& vector, const M44d& to_world) {
  V3d result;
  to_world.multDirMatrix(vector, result);
  return result;
}

/// The factor by which a transform scales a sphere, if it stays one.
double uniform_scale(const XmlElement& element, const M44d& to_world) {
  std::array<V3d, 3> axes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (V3d& axis : axes) axis = transform_vector(axis, to_world);
  const double scale = axes[0].length();
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i; j < 3; ++j)
      if (std::abs(axes[i].dot(axes[j]) / (scale * scale) - (i == j ? 1 : 0)) > 1e-5)
        element.fail("the transform makes it an ellipsoid, which is not supported");
  return scale;
}

struct Place {
  V3d center;
  double radius;
};

Place sphere_place(const XmlElement& element, Properties& properties) {
  const V3f center = properties.point("center", V3f(0));
  const double radius = properties.number("radius", 1);
  if (!(radius > 0)) element.fail("the radius must be positive");
  return {V3d(center), radius};
}

/// The unit disk's image is an ellipse, whose semi-axes are the images of two perpendicular radii.
Geometry make_disk(const M44d& to_world) {
  const V3d u = transform_vector({1, 0, 0}, to_world), v = transform_vector({0, 1, 0}, to_world);
  const hatbox::Vec3 center = to_vec3(V3f(V3d(0) * to_world));
  const V3f normal = transform_normal({0, 0, 1}, to_world);
  const double product = u.dot(v), difference = u.length2() - v.length2();
  if (std::hypot(2 * product, difference) < 1e-5 * (u.length2() + v.length2()))
    return hatbox::Disk{center, to_vec3(normal), static_cast<float>(u.length())};
  const double angle = std::atan2(2 * product, difference) / 2;
  const V3f longer(u * std::cos(angle) + v * std::sin(angle));
  const V3f shorter(v * std::cos(angle) - u * std::sin(angle));
  const float turn = longer.cross(shorter).dot(normal) < 0 ? -1.0f : 1.0f;  // a mirror turns no normal
  return hatbox::Ellipse{center, to_vec3(longer), to_vec3(shorter * turn)};
}

float read_phase(const XmlElement& element, std::vector<std::string>& ignored) {
  element.expect_type({"isotropic", "hg"});
  Properties properties(element, element.children({}));
  const double g = element.type() == "hg" ? properties.number("g", 0.8) : 0;
  if (!(std::abs(g) < 1)) element.fail("g must lie between -1 and 1");
  properties.note_unused(ignored);
  return static_cast<float>(g);
}

}  // namespace

Geometry read_geometry(const XmlElement& element, Properties& properties, const M44d& to_world,
                       const std::filesystem::path& directory) {
  element.expect_type({"sphere", "rectangle", "disk", "cube", "obj"});
  if (element.type() == "sphere") {
    const Place place = sphere_place(element, properties);
    return Sphere{V3f(place.center * to_world), static_cast<float>(place.radius * uniform_scale(element, to_world))};
  }
  if (element.type() == "rectangle") return make_rectangle(to_world);
  if (element.type() == "disk") return make_disk(to_world);
  if (element.type() == "cube") return make_cube(to_world);
  const std::string filename = properties.text("filename", "");
  const bool flat = properties.boolean("faceNormals", false);
  try {
    return load_obj(directory / filename, to_world, flat);
  } catch (const std::exception& error) {
    element.fail(error.what());
  }
}

Light make_light(const XmlElement& element, const Geometry& geometry, const M44d& to_world,
                 std::vector<std::string>& ignored) {
  const auto checked = [&](const auto& light) {
    if (const auto wrong = hatbox::check(light); !wrong.empty())
      element.fail("this " + std::string(element.type()) + " cannot be a light: " + std::string(wrong));
    return light;
  };
  if (const auto* disk = std::get_if<hatbox::Disk>(&geometry)) return checked(*disk);
  if (const auto* ellipse = std::get_if<hatbox::Ellipse>(&geometry)) return checked(*ellipse);
  if (element.type() == "rectangle") return checked(rectangle_light(to_world));
  const auto* mesh = std::get_if<Mesh>(&geometry);
  if (!mesh) element.fail("only a disk, a rectangle, a cube or an obj can be a light");
  MeshLight light = mesh_light(*mesh);
  if (light.triangles.empty()) element.fail("this obj cannot be a light: it has no triangle with an area");
  if (const std::size_t missing = mesh->triangles.size() - light.triangles.size(); missing > 0)
    ignored.push_back(std::to_string(missing) + " degenerate triangle(s) of the obj light (line " +
                      std::to_string(element.line()) + ")");
  return light;
}

Medium::Body read_body(const XmlElement& element, Properties& properties, const M44d& to_world) {
  element.expect_type({"sphere", "cube"});
  if (element.type() == "cube") return {false, to_world.inverse()};
  const Place place = sphere_place(element, properties);
  const M44d ball = M44d().setScale(place.radius) * M44d().setTranslation(place.center);
  return {true, (ball * to_world).inverse()};
}

Medium read_medium(const XmlElement& element, std::vector<std::string>& ignored) {
  element.expect_type({"homogeneous"});
  const auto children = element.children({"phase"});
  Properties properties(element, children);
  Medium medium;
  if (properties.has("sigmaT") || properties.has("albedo")) {
    const Rgb sigma_t = properties.colour("sigmaT", Rgb(1.0f));
    medium.sigma_s = sigma_t * properties.colour("albedo", Rgb(0.75f));
    medium.sigma_a = sigma_t - medium.sigma_s;
  } else {
    if (!properties.has("sigmaS") || !properties.has("sigmaA"))
      element.fail("sigmaS and sigmaA are needed, or sigmaT and albedo");
    medium.sigma_s = properties.colour("sigmaS", Rgb(0.0f));
    medium.sigma_a = properties.colour("sigmaA", Rgb(0.0f));
  }
  const auto scale = static_cast<float>(properties.number("scale", 1));
  medium.sigma_s *= scale;
  medium.sigma_a *= scale;
  for (int channel = 0; channel < 3; ++channel)
    if (!(medium.sigma_s[channel] >= 0 && medium.sigma_a[channel] >= 0))
      element.fail("the coefficients of a medium must not be negative");
  for (const XmlElement& child : children)
    if (child.tag() == "phase") medium.g = read_phase(child, ignored);
  properties.note_unused(ignored);
  return medium;
}

}  // namespace wavefront
