// The border between the library and its kernels: plain pointers, sizes and floats, no standard library types.
// kernels.cpp is compiled once per instruction set and exports one KernelTable each; dispatch.cpp picks one.
#pragma once

#include "disk_constants.h"
#include "ellipse_constants.h"
#include "light_rows.h"
#include "rectangle_constants.h"
#include "triangle_constants.h"

#include <cstddef>
#include <cstdint>

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "hatbox must know a NaN from a number: compile it without -ffast-math"
#endif

namespace hatbox {

/// One call of `sample`: n points, k samples each, outputs that may be null.
template <class Constants>
struct SampleJob {
  LightRows<Constants> lights;
  const float* point[3];
  const float* u;
  const float* v;
  float* direction[3];
  float* distance;
  float* pdf;
  float* place[2];
  float* cosine;
  std::size_t points;
  std::size_t samples_per_point;
};

/// One call of `pdf`, `invert` or `solid_angle`: k queries a point (directions or places) and up to two outputs.
template <class Constants>
struct QueryJob {
  LightRows<Constants> lights;
  const float* point[3];
  const float* query[3];  // direction x, y, z or place s, t; unused for solid_angle
  float* out[2];          // pdf; u, v; solid angle
  std::size_t points;
  std::size_t queries_per_point;
};

template <class Constants>
using SampleKernel = void (*)(const SampleJob<Constants>&, std::size_t begin, std::size_t end);
template <class Constants>
using QueryKernel = void (*)(const QueryJob<Constants>&, std::size_t begin, std::size_t end);

/// All that one map can do. Each kernel does the points [begin, end) of its job. A map that is no bijection has no
/// `invert`.
template <class Constants>
struct MapKernels {
  SampleKernel<Constants> sample;
  QueryKernel<Constants> pdf_of_direction;
  QueryKernel<Constants> pdf_of_place;
  QueryKernel<Constants> invert;
};

/// All that one kind of light can do.
template <class Constants, std::size_t n>
struct LightKernels {
  static constexpr std::size_t map_count = n;

  MapKernels<Constants> maps[n];  // in the order of the light's enum
  QueryKernel<Constants> solid_angle;
};

inline constexpr std::size_t widest_packet = 32;  // lanes that are worked on at a time, at the most

/// One call of an elliptic integral: the arrays of its arguments, in the order of the call.
struct CarlsonJob {
  const float* in[4];
  float* out;
};

using CarlsonKernel = void (*)(const CarlsonJob&, std::size_t begin, std::size_t end);

struct CarlsonKernels {
  CarlsonKernel rf, rc, rd, rj, ellint_f, ellint_e, ellint_pi;
};

/// One call about n segments of rays (equiangular.h): k numbers a segment in, variates or distances, up to two outputs.
struct SegmentJob {
  const float* origin[3];
  const float* direction[3];
  const float* t_min;
  const float* t_max;
  const float* place[3];   // the pivots, or a place in each plane
  const float* normal[3];  // of the planes; of clip alone
  const float* in;         // u or t
  float* out[2];           // t, pdf; pdf; t_min, t_max
  std::size_t segments;
  std::size_t samples_per_segment;
};

using SegmentKernel = void (*)(const SegmentJob&, std::size_t begin, std::size_t end);

struct SegmentKernels {
  SegmentKernel sample, pdf, clip;
};

/// Everything one instruction set has to offer.
struct KernelTable {
  const char* isa;    // what the object was compiled for: "scalar", "sse4_2", …
  std::size_t lanes;  // floats in a packet
  LightKernels<DiskConstants, 7> disk;
  MapKernels<TabulatedDisk> disk_table[2];  // ld_radial, radial
  LightKernels<EllipseConstants, 3> ellipse;
  LightKernels<RectangleConstants, 3> rectangle;
  LightKernels<TriangleConstants, 2> triangle;
  CarlsonKernels carlson;
  SegmentKernels equiangular;
  // residual[i] = x[i]·y[i] − round(x[i]·y[i]): how the tests see that `fma` is fused. n is a multiple of lanes.
  void (*product_residual)(const float* x, const float* y, float* residual, std::size_t n);
};

}  // namespace hatbox
