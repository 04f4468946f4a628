// Samples of a light made of triangles: for each sample one triangle is chosen, and a place on it sampled by hatbox.
#pragma once

#include "scene.h"

namespace wavefront {

/// What a triangle is chosen in proportion to: its solid angle from the shading point, or its power (area, as all
/// triangles of a mesh have one radiance).
enum class Choice { solid_angle, power };

/// Like hatbox::parallel::sample; the density is that of choice and place together. `u` both chooses and, stretched
/// over the interval of what it chose, samples (Shirley, Wang and Zimmerman 1996). Places on the light are not written.
///
/// Choosing by solid angle takes the time of a solid angle for every triangle and point: for meshes of hundreds of
/// triangles, not of thousands.
void sample_mesh(const MeshLight& light, hatbox::TriangleMap map, Choice choice, const hatbox::Points& points,
                 const hatbox::Variates& variates, const hatbox::Samples& out);

}  // namespace wavefront
