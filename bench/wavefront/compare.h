// One scene by several maps: pictures, a table and report.json.
#pragma once

#include "wavefront.h"

#include <filesystem>
#include <string>
#include <vector>

namespace wavefront {

/// What to render, apart from RenderSettings::sampling and light_samples.
struct Comparison {
  std::string scene_name;  // for the report
  std::vector<LightSampling> samplings;
  std::uint32_t reference_spp = 0;  // 0: no reference, no errors
  RenderSettings settings;
  std::filesystem::path out;  // an existing directory
};

/// Writes <map>.exr, <map>.png and report.json; with a reference also reference.exr, reference.png, <map>_error.png
/// and comparison.png. Prints the table to stdout.
///
/// The reference is rendered with the best map, at the same places of the pixels as the maps and with other light
/// samples (see RenderSettings). It is the mean of two halves with their own seeds; what they differ by tells its own
/// error.
void compare(const Scene& scene, const Comparison& comparison);

}  // namespace wavefront
