// What every public call does, whatever its light and map: check the arrays, make the job, run its kernel. The caller
// has checked the light and made `constants` of it.
#pragma once

#include "arguments.h"
#include "kernel_table.h"
#include "schedule.h"

#include <array>
#include <span>

namespace hatbox {

inline float* or_null(std::span<float> array) { return array.empty() ? nullptr : array.data(); }

template <class Constants>
void call_sample(const Schedule& schedule, const MapKernels<Constants>& kernels, const Constants& constants,
                 const Points& points, const Variates& variates, const Samples& out) {
  const BatchSize size = checked_size(points, variates);
  check_outputs(out, size.total());
  const SampleJob<Constants> job = {
      .lights = {&constants, nullptr, 0},
      .point = {points.x.data(), points.y.data(), points.z.data()},
      .u = variates.u.data(),
      .v = variates.v.data(),
      .direction = {or_null(out.x), or_null(out.y), or_null(out.z)},
      .distance = or_null(out.distance),
      .pdf = or_null(out.pdf),
      .place = {or_null(out.s), or_null(out.t)},
      .cosine = or_null(out.cosine),
      .points = size.points,
      .samples_per_point = size.per_point,
  };
  run(schedule, size.points, size.per_point, kernels.sample, job);
}

/// Any query whose arrays are checked: `in` are its directions or places, `out` its one or two outputs.
template <class Constants>
void call_query(const Schedule& schedule, QueryKernel<Constants> kernel, const Constants& constants, const Points& points,
                BatchSize size, const std::array<const float*, 3>& in, const std::array<float*, 2>& out) {
  const QueryJob<Constants> job = {
      .lights = {&constants, nullptr, 0},
      .point = {points.x.data(), points.y.data(), points.z.data()},
      .query = {in[0], in[1], in[2]},
      .out = {out[0], out[1]},
      .points = size.points,
      .queries_per_point = size.per_point,
  };
  run(schedule, size.points, size.per_point, kernel, job);
}

template <class Constants>
void call_pdf(const Schedule& schedule, const MapKernels<Constants>& kernels, const Constants& constants, const Points& points,
              const Directions& directions, std::span<float> out) {
  const BatchSize size = checked_size(points, directions);
  check_size("out", out, size.total());
  call_query(schedule, kernels.pdf_of_direction, constants, points, size,
             {directions.x.data(), directions.y.data(), directions.z.data()}, {out.data()});
}

template <class Constants>
void call_pdf(const Schedule& schedule, const MapKernels<Constants>& kernels, const Constants& constants, const Points& points,
              const Places& places, std::span<float> out) {
  const BatchSize size = checked_size(points, places);
  check_size("out", out, size.total());
  call_query(schedule, kernels.pdf_of_place, constants, points, size, {places.s.data(), places.t.data()}, {out.data()});
}

template <class Constants>
void call_invert(const Schedule& schedule, const MapKernels<Constants>& kernels, const Constants& constants,
                 const Points& points, const Directions& directions, std::span<float> u, std::span<float> v) {
  const BatchSize size = checked_size(points, directions);
  check_size("u", u, size.total());
  check_size("v", v, size.total());
  call_query(schedule, kernels.invert, constants, points, size,
             {directions.x.data(), directions.y.data(), directions.z.data()}, {u.data(), v.data()});
}

template <class Constants>
void call_solid_angle(const Schedule& schedule, QueryKernel<Constants> kernel, const Constants& constants, const Points& points,
                      std::span<float> out) {
  const BatchSize size = {checked_size(points), 1};
  check_size("out", out, size.total());
  call_query(schedule, kernel, constants, points, size, {}, {out.data()});
}

}  // namespace hatbox
