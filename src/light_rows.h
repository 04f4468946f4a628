// What the library keeps of a light: its frame and its lengths, at most 24 numbers, made once a call or once a
// LightSet, in double, and then rounded. <light>_constants.h has it as a struct over T, which is float, double for the
// tests that run the kernels' text in double, or a vector of them, a lane a light, in the kernels themselves. Nothing
// else may be a member: kernels fill these structs number by number (packet_lights.h). The lights must be valid (see
// their `check`).
#pragma once

#include <cstdint>

namespace hatbox {

/// The lights of a call: rows[0] for all points, or where there is an index, rows[index[i] - first] for point i.
/// `Constants` is what is kept of a light, such as DiskConstants.
template <class Constants>
struct LightRows {
  const Constants* rows;
  const std::uint32_t* index;
  std::uint32_t first;
};

}  // namespace hatbox
