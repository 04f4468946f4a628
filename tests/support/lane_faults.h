// What must hold of every lane of every call, whatever it was called with: the bounds that the public headers state.
#pragma once

#include "reference/equiangular_reference.h"
#include "support/sampler.h"
#include "support/workloads.h"

#include <cstddef>

namespace hatbox::test {

/// What is wrong with lane i, of that point, of what `sample` wrote, all outputs asked for; null if nothing is.
const char* fault_of(const Sampler& sampler, const Vec3& point, const SampleArrays& samples, std::size_t i);

/// What is wrong with what `pdf` wrote; null if nothing is.
const char* fault_of_density(float density);

/// What is wrong with what `invert` wrote; null if nothing is.
const char* fault_of_inverse(float u, float v);

/// What is wrong with what `solid_angle` wrote; null if nothing is.
const char* fault_of_solid_angle(float omega);

/// What is wrong with what equiangular `sample` wrote of a segment, and with what `pdf` says of that distance; null if
/// nothing is.
const char* fault_of_distance(const reference::Segment& segment, float t, float pdf, float asked);

/// What is wrong with what is left of a clipped segment; null if nothing is.
const char* fault_of_clipped(const reference::Segment& segment, float t_min, float t_max);

}  // namespace hatbox::test
