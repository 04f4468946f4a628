// What every public call does, whatever its light and map: check the arrays, make the job, run its kernel. The caller
// has checked the light and made `constants` of it.
#pragma once

#include "arguments.h"
#include "kernel_table.h"
#include "schedule.h"

#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>
#include <string>

namespace hatbox {

/// The checked arrays of a call: numbers of its points, of their samples or queries, and of the results.
struct CallArrays {
  BatchSize size;
  std::array<const float*, 3> point;
  std::array<const float*, 3> in;  // u, v; a direction's x, y, z; a place's s, t; those there are
  std::array<float*, 8> out;       // of Samples, in its order, where a null is not wanted; pdf; u, v; solid angle

  /// The first that is wanted, if any.
  const float* any_out() const {
    const auto wanted = std::ranges::find_if(out, [](const float* array) { return array != nullptr; });
    return wanted == out.end() ? nullptr : *wanted;
  }
};

inline std::array<const float*, 3> pointers(const Points& points) {
  return {points.x.data(), points.y.data(), points.z.data()};
}
inline float* or_null(std::span<float> array) { return array.empty() ? nullptr : array.data(); }

inline CallArrays checked_sample(const Points& points, const Variates& variates, const Samples& out) {
  const BatchSize size = checked_size(points, variates);
  check_outputs(out, size.total());
  return {size,
          pointers(points),
          {variates.u.data(), variates.v.data()},
          {or_null(out.x), or_null(out.y), or_null(out.z), or_null(out.distance), or_null(out.pdf), or_null(out.s),
           or_null(out.t), or_null(out.cosine)}};
}

inline CallArrays checked_pdf(const Points& points, const Directions& directions, std::span<float> out) {
  const BatchSize size = checked_size(points, directions);
  check_size("out", out, size.total());
  return {size, pointers(points), {directions.x.data(), directions.y.data(), directions.z.data()}, {out.data()}};
}

inline CallArrays checked_pdf(const Points& points, const Places& places, std::span<float> out) {
  const BatchSize size = checked_size(points, places);
  check_size("out", out, size.total());
  return {size, pointers(points), {places.s.data(), places.t.data()}, {out.data()}};
}

inline CallArrays checked_invert(const Points& points, const Directions& directions, std::span<float> u,
                                 std::span<float> v) {
  const BatchSize size = checked_size(points, directions);
  check_size("u", u, size.total());
  check_size("v", v, size.total());
  return {
      size, pointers(points), {directions.x.data(), directions.y.data(), directions.z.data()}, {u.data(), v.data()}};
}

inline CallArrays checked_solid_angle(const Points& points, std::span<float> out) {
  const BatchSize size = {checked_size(points), 1};
  check_size("out", out, size.total());
  return {size, pointers(points), {}, {out.data()}};
}

/// The kernels of a map of a light, `name` being the enum's.
template <class Constants, std::size_t n, class Map>
const MapKernels<Constants>& kernels_of(const LightKernels<Constants, n>& light, Map map, const char* name) {
  const auto index = static_cast<std::size_t>(map);
  if (index < n) return light.maps[index];
  throw std::invalid_argument(std::string("map: there is no ") + name + " " + std::to_string(index));
}

template <class Constants>
SampleJob<Constants> sample_job(const LightRows<Constants>& lights, const CallArrays& arrays) {
  const auto& [size, point, in, out] = arrays;
  return {.lights = lights,
          .point = {point[0], point[1], point[2]},
          .u = in[0],
          .v = in[1],
          .direction = {out[0], out[1], out[2]},
          .distance = out[3],
          .pdf = out[4],
          .place = {out[5], out[6]},
          .cosine = out[7],
          .points = size.points,
          .samples_per_point = size.per_point};
}

template <class Constants>
QueryJob<Constants> query_job(const LightRows<Constants>& lights, const CallArrays& arrays) {
  const auto& [size, point, in, out] = arrays;
  return {.lights = lights,
          .point = {point[0], point[1], point[2]},
          .query = {in[0], in[1], in[2]},
          .out = {out[0], out[1]},
          .points = size.points,
          .queries_per_point = size.per_point};
}

template <class Constants>
LightRows<Constants> one_light(const Constants& constants) {
  return {&constants, nullptr, 0};
}

template <class Constants>
void call_sample(const Schedule& schedule, const MapKernels<Constants>& kernels, const Constants& constants,
                 const Points& points, const Variates& variates, const Samples& out) {
  const CallArrays arrays = checked_sample(points, variates, out);
  run(schedule, arrays.size.points, arrays.size.per_point, kernels.sample, sample_job(one_light(constants), arrays),
      arrays.any_out());
}

template <class Constants>
void call_query(const Schedule& schedule, QueryKernel<Constants> kernel, const Constants& constants,
                const CallArrays& arrays) {
  run(schedule, arrays.size.points, arrays.size.per_point, kernel, query_job(one_light(constants), arrays),
      arrays.any_out());
}

template <class Constants>
void call_pdf(const Schedule& schedule, const MapKernels<Constants>& kernels, const Constants& constants,
              const Points& points, const Directions& directions, std::span<float> out) {
  call_query(schedule, kernels.pdf_of_direction, constants, checked_pdf(points, directions, out));
}

template <class Constants>
void call_pdf(const Schedule& schedule, const MapKernels<Constants>& kernels, const Constants& constants,
              const Points& points, const Places& places, std::span<float> out) {
  call_query(schedule, kernels.pdf_of_place, constants, checked_pdf(points, places, out));
}

template <class Constants>
void call_invert(const Schedule& schedule, const MapKernels<Constants>& kernels, const Constants& constants,
                 const Points& points, const Directions& directions, std::span<float> u, std::span<float> v) {
  call_query(schedule, kernels.invert, constants, checked_invert(points, directions, u, v));
}

template <class Constants>
void call_solid_angle(const Schedule& schedule, QueryKernel<Constants> kernel, const Constants& constants,
                      const Points& points, std::span<float> out) {
  call_query(schedule, kernel, constants, checked_solid_angle(points, out));
}

}  // namespace hatbox
