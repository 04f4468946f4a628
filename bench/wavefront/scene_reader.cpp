#include "scene_reader.h"

#include "medium.h"
#include "shape_reader.h"
#include "transform_reader.h"
#include "xml_element.h"

#include <algorithm>
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
    for (const XmlElement& child : root.children({"integrator", "sensor", "bsdf", "medium", "shape"})) {
      if (child.tag() == "integrator") {
        read_integrator(child);
      } else if (child.tag() == "sensor") {
        read_sensor(child);
        has_sensor = true;
      } else if (child.tag() == "bsdf") {
        reflectances_[child.text("id")] = read_bsdf(child);
      } else if (child.tag() == "medium") {
        media_[child.text("id")] = read_medium(child, scene_.ignored);
      } else if (child.tag() == "shape") {
        read_shape(child);
      } else {
        child.fail("a property of nothing");
      }
    }
    if (!has_sensor) root.fail("has no sensor");
    if (scene_.medium && !scene_.medium->body && lowest_extinction(*scene_.medium) == 0)
      root.fail("a medium that fills all of space must absorb or scatter in every channel");
    if (scene_.emitters.empty())
      root.fail("has no light: a disk, rectangle, cube or obj with an area emitter is needed");
    return std::move(scene_);
  }

 private:
  void read_integrator(const XmlElement& element) {
    element.expect_type({"direct", "voldirect"});
    Properties properties(element, element.children({}));
    scene_.hide_emitters = properties.boolean("hideEmitters", false);
    properties.note_unused(scene_.ignored);
  }

  void read_sensor(const XmlElement& element) {
    element.expect_type({"perspective"});
    const auto children = element.children({"transform", "sampler", "film", "ref"});
    Properties properties(element, children);
    const std::string axis = properties.text("fovAxis", "x");
    if (axis != "x" && axis != "y") element.fail("fovAxis must be x or y, not '" + axis + "'");
    const double fov = properties.number("fov", 50);
    if (!(fov > 0 && fov < 180)) element.fail("fov must lie between 0 and 180 degrees");
    scene_.view = {to_world(children), fov, axis[0]};
    for (const XmlElement& child : children) {
      if (child.tag() == "sampler") read_sampler(child);
      if (child.tag() == "film") read_film(child);
      if (child.tag() == "ref") fill(child, {});  // the medium that the camera is in
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
      if (child.tag() == "rfilter") child.expect_type({"box"});
    Properties properties(element, children);
    scene_.width = properties.integer("width", scene_.width);
    scene_.height = properties.integer("height", scene_.height);
    if (scene_.width < 1 || scene_.height < 1) element.fail("width and height must be positive");
    properties.note_unused(scene_.ignored);
  }

  Rgb read_bsdf(const XmlElement& element) {
    element.expect_type({"diffuse"});
    Properties properties(element, element.children({}));
    const Rgb reflectance = properties.colour("reflectance", Rgb(0.5f));
    properties.note_unused(scene_.ignored);
    return reflectance;
  }

  void read_shape(const XmlElement& element) {
    const auto children = element.children({"transform", "ref", "bsdf", "emitter"});
    const auto interior = std::find_if(children.begin(), children.end(), [](const XmlElement& child) {
      return child.tag() == "ref" && child.name() == "interior";
    });
    Properties properties(element, children);
    if (interior != children.end()) {
      if (std::any_of(children.begin(), children.end(), [&](const XmlElement& child) {
            return child.tag() == "bsdf" || child.tag() == "emitter" || (child.tag() == "ref" && &child != &*interior);
          }))
        element.fail("a shape with a medium inside can have no surface");
      fill(*interior, read_body(element, properties, to_world(children)));
    } else {
      read_surface(element, children, properties);
    }
    properties.note_unused(scene_.ignored);
  }

  void read_surface(const XmlElement& element, const std::vector<XmlElement>& children, Properties& properties) {
    const M44d transform = to_world(children);
    Shape shape{read_geometry(element, properties, transform, source_.path.parent_path()), Rgb(0.5f), {}};
    for (const XmlElement& child : children) {
      if (child.tag() == "ref") shape.reflectance = referred(reflectances_, child, "bsdf");
      if (child.tag() == "bsdf") shape.reflectance = read_bsdf(child);
      if (child.tag() == "emitter") {
        shape.emitter = scene_.emitters.size();
        scene_.emitters.push_back(read_emitter(child, make_light(element, shape.geometry, transform, scene_.ignored)));
      }
    }
    scene_.shapes.push_back(std::move(shape));
  }

  /// A medium fills the body that it is the inside of; if the camera alone is in it, all of space.
  void fill(const XmlElement& ref, const std::optional<Medium::Body>& body) {
    const std::string id = ref.text("id");
    const Medium& medium = referred(media_, ref, "medium");
    if (scene_.medium && medium_id_ != id) ref.fail("a second medium, which is not supported");
    if (scene_.medium && scene_.medium->body && body) ref.fail("a second body of the medium, which is not supported");
    if (!scene_.medium) scene_.medium = medium;
    medium_id_ = id;
    if (body) scene_.medium->body = body;
  }

  Emitter read_emitter(const XmlElement& element, Light light) {
    element.expect_type({"area"});
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

  template <class T>
  static const T& referred(const std::map<std::string, T>& known, const XmlElement& ref, const char* what) {
    const auto entry = known.find(ref.text("id"));
    if (entry == known.end()) ref.fail("no " + std::string(what) + " '" + ref.text("id") + "' before this line");
    return entry->second;
  }

  const XmlText& source_;
  Scene scene_;
  std::map<std::string, Rgb> reflectances_;
  std::map<std::string, Medium> media_;
  std::string medium_id_;  // of the one in the scene
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
