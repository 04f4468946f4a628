// Triangle meshes: Wavefront OBJ files, the rectangle and the cube; the first two as lights.
#pragma once

#include "scene.h"

#include <filesystem>

namespace wavefront {

/// All groups of an OBJ file in one mesh, in world space. Normals are the file's; where it has none they are averaged
/// over the faces round a vertex, unless `flat`. Throws std::runtime_error.
Mesh load_obj(const std::filesystem::path& path, const Imath::M44d& to_world, bool flat);

/// [-1, 1]² in the plane z = 0, facing +z.
Mesh make_rectangle(const Imath::M44d& to_world);

/// [-1, 1]³, facing outwards.
Mesh make_cube(const Imath::M44d& to_world);

/// The rectangle as a light; not checked. A mirroring transform turns the rectangle, not its normal.
hatbox::Rectangle rectangle_light(const Imath::M44d& to_world);

/// The triangles of a mesh, without those that cannot be lights. Their front is that of the mesh's normals, if it has
/// any.
MeshLight mesh_light(const Mesh& mesh);

/// Transforms a normal, to unit length.
V3f transform_normal(const V3f& normal, const Imath::M44d& to_world);

}  // namespace wavefront
