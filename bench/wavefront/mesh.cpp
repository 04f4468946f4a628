#include "mesh.h"

#include <tiny_obj_loader.h>

#include <map>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace wavefront {
namespace {

using Imath::M44d;

V3f transform_point(const V3f& point, const M44d& to_world) { return V3f(Imath::V3d(point) * to_world); }

V3f triple(const std::vector<float>& values, int index) {
  const auto at = 3 * static_cast<std::size_t>(index);
  return {values.at(at), values.at(at + 1), values.at(at + 2)};
}

/// OBJ indexes positions and normals separately; here a vertex is a pair of both.
class VertexMerger {
 public:
  VertexMerger(const tinyobj::attrib_t& attributes, bool with_normals, const M44d& to_world, Mesh& mesh)
      : attributes_(attributes), with_normals_(with_normals), to_world_(to_world), mesh_(mesh) {}

  std::uint32_t operator()(const tinyobj::index_t& index) {
    const int normal = with_normals_ ? index.normal_index : -1;
    const auto [entry, is_new] =
        vertices_.try_emplace({index.vertex_index, normal}, static_cast<std::uint32_t>(mesh_.positions.size()));
    if (is_new) {
      mesh_.positions.push_back(transform_point(triple(attributes_.vertices, index.vertex_index), to_world_));
      if (with_normals_) mesh_.normals.push_back(transform_normal(triple(attributes_.normals, normal), to_world_));
    }
    return entry->second;
  }

 private:
  const tinyobj::attrib_t& attributes_;
  bool with_normals_;
  const M44d& to_world_;
  Mesh& mesh_;
  std::map<std::pair<int, int>, std::uint32_t> vertices_;
};

bool every_corner_has_a_normal(const std::vector<tinyobj::shape_t>& groups) {
  for (const auto& group : groups)
    for (const auto& index : group.mesh.indices)
      if (index.normal_index < 0) return false;
  return true;
}

/// Averages face normals weighted by area, which is the length of the cross product.
void average_normals(Mesh& mesh) {
  mesh.normals.assign(mesh.positions.size(), V3f(0));
  for (const auto& [a, b, c] : mesh.triangles) {
    const V3f normal = (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]);
    for (const std::uint32_t vertex : {a, b, c}) mesh.normals[vertex] += normal;
  }
  for (V3f& normal : mesh.normals) normal.normalize();
}

}  // namespace

V3f transform_normal(const V3f& normal, const M44d& to_world) {
  Imath::V3d result;
  to_world.inverse().transposed().multDirMatrix(Imath::V3d(normal), result);
  return V3f(result.normalized());
}

Mesh load_obj(const std::filesystem::path& path, const M44d& to_world, bool flat) {
  tinyobj::ObjReader reader;
  if (!reader.ParseFromFile(path.string())) throw std::runtime_error("cannot read " + path.string());
  Mesh mesh;
  const bool with_normals = !flat && every_corner_has_a_normal(reader.GetShapes());
  VertexMerger merge(reader.GetAttrib(), with_normals, to_world, mesh);
  for (const auto& group : reader.GetShapes()) {
    const auto& corners = group.mesh.indices;  // triangulated by the reader
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
      mesh.triangles.push_back({merge(corners[i]), merge(corners[i + 1]), merge(corners[i + 2])});
  }
  if (mesh.triangles.empty()) throw std::runtime_error("no faces in " + path.string());
  if (!flat && !with_normals) average_normals(mesh);
  return mesh;
}

Mesh make_rectangle(const M44d& to_world) {
  Mesh mesh;
  for (const V3f& corner : {V3f(-1, -1, 0), V3f(1, -1, 0), V3f(1, 1, 0), V3f(-1, 1, 0)})
    mesh.positions.push_back(transform_point(corner, to_world));
  mesh.normals.assign(4, transform_normal({0, 0, 1}, to_world));
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

Mesh make_cube(const M44d& to_world) {
  using Imath::V3d;
  const V3d sides[6] = {{90, 0, 0}, {-90, 0, 0}, {0, 90, 0}, {0, -90, 0}, {0, 0, 0}, {180, 0, 0}};
  Mesh mesh;
  for (const V3d& turn : sides) {
    M44d side;
    side.setTranslation(V3d(0, 0, 1));
    side *= M44d().setEulerAngles(turn * (std::numbers::pi / 180));
    const Mesh face = make_rectangle(side * to_world);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const auto& [a, b, c] : face.triangles) mesh.triangles.push_back({first + a, first + b, first + c});
    mesh.positions.insert(mesh.positions.end(), face.positions.begin(), face.positions.end());
    mesh.normals.insert(mesh.normals.end(), face.normals.begin(), face.normals.end());
  }
  return mesh;
}

hatbox::Rectangle rectangle_light(const M44d& to_world) {
  const V3f corner = transform_point({-1, -1, 0}, to_world);
  V3f edges[2];
  to_world.multDirMatrix(V3f(2, 0, 0), edges[0]);
  to_world.multDirMatrix(V3f(0, 2, 0), edges[1]);
  if (edges[0].cross(edges[1]).dot(transform_normal({0, 0, 1}, to_world)) < 0) std::swap(edges[0], edges[1]);
  return {to_vec3(corner), to_vec3(edges[0]), to_vec3(edges[1])};
}

MeshLight mesh_light(const Mesh& mesh) {
  MeshLight light;
  for (std::uint32_t index = 0; index < mesh.triangles.size(); ++index) {
    const auto& [a, b, c] = mesh.triangles[index];
    const V3f &p = mesh.positions[a], &q = mesh.positions[b], &r = mesh.positions[c];
    hatbox::Triangle triangle{to_vec3(p), to_vec3(q), to_vec3(r)};
    const bool turned =
        !mesh.normals.empty() && (q - p).cross(r - p).dot(mesh.normals[a] + mesh.normals[b] + mesh.normals[c]) < 0;
    if (turned) std::swap(triangle.b, triangle.c);
    if (!hatbox::check(triangle).empty()) continue;
    light.triangles.push_back(triangle);
    light.of_mesh.push_back(index);
  }
  return light;
}

}  // namespace wavefront
