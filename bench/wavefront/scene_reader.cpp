#include "scene_reader.h"

#include "mesh.h"
#include "transform_reader.h"
#include "xml_element.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

namespace wavefront {
namespace {

using Imath::M44d;

class Reader {
 public:
  explicit Reader(const XmlText& source) : source_(source) {}

  Scene read(const XmlElement& root) {
    bool has_sensor = false;
    for (const XmlElement& child : root.children({"integrator", "sensor", "bsdf", "shape"})) {
      if (child.tag() == "integrator") {
        read_integrator(child);
      } else if (child.tag() == "sensor") {
        read_sensor(child);
        has_sensor = true;
      } else if (child.tag() == "bsdf") {
        reflectances_[child.text("id")] = read_bsdf(child);
      } else if (child.tag() == "shape") {
        read_shape(child);
      } else {
        child.fail("a property of nothing");
      }
    }
    if (!has_sensor) root.fail("has no sensor");
    if (scene_.emitters.empty()) root.fail("has no light: a disk, rectangle or obj with an area emitter is needed");
    return std::move(scene_);
  }

 private:
  static void expect_type(const XmlElement& element, std::initializer_list<std::string_view> known) {
    std::string list;
    for (const std::string_view type : known) {
      if (element.type() == type) return;
      list += (list.empty() ? "" : ", ") + std::string(type);
    }
    element.fail("unknown type '" + std::string(element.type()) + "' (known: " + list + ")");
  }

  void read_integrator(const XmlElement& element) {
    expect_type(element, {"direct", "voldirect"});
    Properties properties(element, element.children({}));
    scene_.hide_emitters = properties.boolean("hideEmitters", false);
    properties.note_unused(scene_.ignored);
  }

  void read_sensor(const XmlElement& element) {
    expect_type(element, {"perspective"});
    const auto children = element.children({"transform", "sampler", "film"});
    Properties properties(element, children);
    const std::string axis = properties.text("fovAxis", "x");
    if (axis != "x" && axis != "y") element.fail("fovAxis must be x or y, not '" + axis + "'");
    const double fov = properties.number("fov", 50);
    if (!(fov > 0 && fov < 180)) element.fail("fov must lie between 0 and 180 degrees");
    scene_.view = {to_world(children), fov, axis[0]};
    for (const XmlElement& child : children) {
      if (child.tag() == "sampler") read_sampler(child);
      if (child.tag() == "film") read_film(child);
    }
    properties.note_unused(scene_.ignored);
  }

  void read_sampler(const XmlElement& element) {
    Properties properties(element, element.children({}));
    const int count = properties.integer("sampleCount", 4);
    if (count < 1) element.fail("sampleCount must be positive");
    scene_.samples_per_pixel = static_cast<std::uint32_t>(count);
    properties.note_unused(scene_.ignored);
  }

  void read_film(const XmlElement& element) {
    const auto children = element.children({"rfilter"});
    for (const XmlElement& child : children)
      if (child.tag() == "rfilter") expect_type(child, {"box"});
    Properties properties(element, children);
    scene_.width = properties.integer("width", scene_.width);
    scene_.height = properties.integer("height", scene_.height);
    if (scene_.width < 1 || scene_.height < 1) element.fail("width and height must be positive");
    properties.note_unused(scene_.ignored);
  }

  Rgb read_bsdf(const XmlElement& element) {
    expect_type(element, {"diffuse"});
    Properties properties(element, element.children({}));
    const Rgb reflectance = properties.colour("reflectance", Rgb(0.5f));
    properties.note_unused(scene_.ignored);
    return reflectance;
  }

  void read_shape(const XmlElement& element) {
    expect_type(element, {"sphere", "rectangle", "disk", "obj"});
    const auto children = element.children({"transform", "ref", "bsdf", "emitter"});
    Properties properties(element, children);
    Shape shape{read_geometry(element, properties, to_world(children)), Rgb(0.5f), {}};
    for (const XmlElement& child : children) {
      if (child.tag() == "ref") shape.reflectance = referred(child);
      if (child.tag() == "bsdf") shape.reflectance = read_bsdf(child);
      if (child.tag() == "emitter") {
        shape.emitter = scene_.emitters.size();
        scene_.emitters.push_back(read_emitter(child, make_light(element, shape, to_world(children))));
      }
    }
    scene_.shapes.push_back(std::move(shape));
    properties.note_unused(scene_.ignored);
  }

  std::variant<Sphere, hatbox::Disk, Mesh> read_geometry(const XmlElement& element, Properties& properties,
                                                         const M44d& to_world) const {
    if (element.type() == "sphere") {
      const V3f center = properties.point("center", V3f(0));
      const double radius = properties.number("radius", 1);
      if (!(radius > 0)) element.fail("the radius must be positive");
      return Sphere{V3f(Imath::V3d(center) * to_world), static_cast<float>(radius * uniform_scale(element, to_world))};
    }
    if (element.type() == "rectangle") return make_rectangle(to_world);
    if (element.type() == "disk") {
      const V3f center = V3f(Imath::V3d(0) * to_world);
      const V3f normal = transform_normal({0, 0, 1}, to_world);
      const auto radius = static_cast<float>(uniform_scale(element, to_world));
      return hatbox::Disk{{center.x, center.y, center.z}, {normal.x, normal.y, normal.z}, radius};
    }
    try {
      const std::string filename = properties.text("filename", "");
      return load_obj(source_.path.parent_path() / filename, to_world, properties.boolean("faceNormals", false));
    } catch (const SceneError&) {
      throw;
    } catch (const std::exception& error) {
      element.fail(error.what());
    }
  }

  /// The factor by which a transform scales a sphere, or a disk in the plane z = 0, if they stay what they are.
  static double uniform_scale(const XmlElement& element, const M44d& to_world) {
    std::array<Imath::V3d, 3> axes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    for (Imath::V3d& axis : axes) to_world.multDirMatrix(Imath::V3d(axis), axis);
    const std::size_t used = element.type() == "disk" ? 2 : 3;
    const double scale = axes[0].length();
    for (std::size_t i = 0; i < used; ++i)
      for (std::size_t j = i; j < used; ++j)
        if (std::abs(axes[i].dot(axes[j]) / (scale * scale) - (i == j ? 1 : 0)) > 1e-5)
          element.fail("the transform makes it an ellipse or an ellipsoid, which is not supported");
    return scale;
  }

  Light make_light(const XmlElement& element, const Shape& shape, const M44d& to_world) {
    const auto checked = [&](const auto& light) {
      if (const auto wrong = hatbox::check(light); !wrong.empty())
        element.fail("this " + std::string(element.type()) + " cannot be a light: " + std::string(wrong));
      return light;
    };
    if (const auto* disk = std::get_if<hatbox::Disk>(&shape.geometry)) return checked(*disk);
    if (element.type() == "rectangle") return checked(rectangle_light(to_world));
    const auto* mesh = std::get_if<Mesh>(&shape.geometry);
    if (!mesh) element.fail("only a disk, a rectangle or an obj can be a light");
    MeshLight light = mesh_light(*mesh);
    if (light.triangles.empty()) element.fail("this obj cannot be a light: it has no triangle with an area");
    if (const std::size_t missing = mesh->triangles.size() - light.triangles.size(); missing > 0)
      scene_.ignored.push_back(std::to_string(missing) + " degenerate triangle(s) of the obj light (line " +
                               std::to_string(element.line()) + ")");
    return light;
  }

  Emitter read_emitter(const XmlElement& element, Light light) {
    expect_type(element, {"area"});
    Properties properties(element, element.children({}));
    Emitter emitter{std::move(light), properties.colour("radiance", Rgb(1.0f)),
                    properties.boolean("doubleSided", false)};
    properties.note_unused(scene_.ignored);
    return emitter;
  }

  static M44d to_world(const std::vector<XmlElement>& children) {
    M44d result;
    for (const XmlElement& child : children)
      if (child.tag() == "transform") {
        if (child.name() != "toWorld") child.fail("must be named toWorld");
        result = read_transform(child);
      }
    return result;
  }

  Rgb referred(const XmlElement& ref) const {
    const auto entry = reflectances_.find(ref.text("id"));
    if (entry == reflectances_.end()) ref.fail("no bsdf '" + ref.text("id") + "' before this line");
    return entry->second;
  }

  const XmlText& source_;
  Scene scene_;
  std::map<std::string, Rgb> reflectances_;
};

}  // namespace

Scene parse_scene(const std::string& text, const std::filesystem::path& path) {
  const XmlText source{path, text};
  pugi::xml_document document;
  const auto result = document.load_buffer(text.data(), text.size());
  if (!result) {
    const auto line = 1 + std::count(text.begin(), text.begin() + result.offset, '\n');
    throw SceneError(path.string() + ":" + std::to_string(line) + ": " + result.description());
  }
  const XmlElement root(source, document.document_element());
  if (root.tag() != "scene") root.fail("the outermost element must be <scene>");
  return Reader(source).read(root);
}

Scene read_scene(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (!file || !(text << file.rdbuf())) throw SceneError("cannot read the scene file " + path.string());
  return parse_scene(text.str(), path);
}

}  // namespace wavefront
