// Triangle meshes: Wavefront OBJ files and the rectangle.
#pragma once

#include "scene.h"

#include <filesystem>

namespace wavefront {

/// All groups of an OBJ file in one mesh, in world space. Normals are the file's; where it has none they are averaged
/// over the faces round a vertex, unless `flat`. Throws std::runtime_error.
Mesh load_obj(const std::filesystem::path& path, const Imath::M44d& to_world, bool flat);

/// [-1, 1]² in the plane z = 0, facing +z.
Mesh make_rectangle(const Imath::M44d& to_world);

/// Transforms a normal, to unit length.
V3f transform_normal(const V3f& normal, const Imath::M44d& to_world);

}  // namespace wavefront
