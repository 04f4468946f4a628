// Diffuse inter-reflection: every vertex on a surface sends its camera path on, in one direction, to the next surface.
#pragma once

#include "stage.h"

namespace wavefront {

class BounceStage {
 public:
  explicit BounceStage(const Stage& stage) : stage_(stage) {}

  /// Fills `next` with where the paths of `vertices` arrive after their bounce number `bounce`, 1 the first, directions
  /// in proportion to the cosine. What they see of lights on their way is left out: it was gathered before.
  void trace(const VertexQueue& vertices, std::uint32_t bounce, VertexQueue& next) const;

 private:
  void trace_packet(const VertexQueue& vertices, std::uint32_t bounce, std::size_t block, Range range,
                    VertexQueue& next) const;

  const Stage& stage_;
};

}  // namespace wavefront
