// Reads the part of Mitsuba 0.5's scene format that scenes with diffuse surfaces and fog under area lights need:
//   integrator (direct, voldirect)   hideEmitters
//   sensor (perspective)             toWorld, fov, fovAxis; sampler sampleCount; film width, height; the medium it is
//   in bsdf (diffuse)                   reflectance; named by id and used by <ref> medium (homogeneous) sigmaS and
//   sigmaA or sigmaT and albedo, scale; phase (isotropic, hg); one a scene shape                            sphere,
//   rectangle, disk, cube, obj, with toWorld; emitter (area, not on a sphere):
//                                      radiance, doubleSided; or the medium that is inside (sphere, cube)
// An element or a type that is not listed is an error; a property that is not is listed in Scene::ignored.
#pragma once

#include "scene.h"

#include <filesystem>
#include <string>

namespace wavefront {

/// Throws SceneError, which names file, line and element.
Scene read_scene(const std::filesystem::path& path);

/// The same from memory; `path` is for messages, and where relative file names start.
Scene parse_scene(const std::string& text, const std::filesystem::path& path);

}  // namespace wavefront
