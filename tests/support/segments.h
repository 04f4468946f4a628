// Segments of rays and their pivots, hard ones among them, for the tests of the media kit.
#pragma once

#include "reference/equiangular_reference.h"
#include "support/workloads.h"

#include <hatbox/equiangular.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace hatbox::test {

struct SegmentArrays {
  PointArrays origin, direction, pivot;
  std::vector<float> t_min, t_max;

  std::size_t size() const { return t_min.size(); }
  Segments view() const { return {origin.x, origin.y, origin.z, direction.x, direction.y, direction.z, t_min, t_max}; }
  reference::Segment segment(std::size_t i) const { return {origin[i], direction[i], t_min[i], t_max[i]}; }
  void push_back(const reference::Segment& segment, const Vec3& at);
  SegmentArrays pick(std::span<const std::size_t> indices) const;
};

/// How a segment lies to its pivot.
enum class Situation { ordinary, far_pivot, short_segment, past_pivot, through_pivot, in_line, at_an_end, from_afar };
inline constexpr Situation all_situations[] = {
    Situation::ordinary,      Situation::far_pivot, Situation::short_segment, Situation::past_pivot,
    Situation::through_pivot, Situation::in_line,   Situation::at_an_end,     Situation::from_afar};
const char* name(Situation situation);

/// The canonical pose has rays along x, their pivots in the plane of x and y; the general one turns and moves them.
SegmentArrays make_segments(Situation situation, Pose pose, std::size_t n, std::uint32_t seed = 4);

/// Some of each kind.
SegmentArrays mixed_segments(Pose pose, std::size_t n_of_each);

struct DistanceArrays {
  std::vector<float> t, pdf;
};

DistanceArrays sample(const SegmentArrays& segments, std::span<const float> u, std::optional<std::size_t> grain = {});
std::vector<float> pdf(const SegmentArrays& segments, std::span<const float> t, std::optional<std::size_t> grain = {});

}  // namespace hatbox::test
