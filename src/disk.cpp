// The public calls for disks: check the arguments, make the job, run its kernel.
#include "arguments.h"
#include "disk_constants.h"
#include "dispatch.h"
#include "schedule.h"

#include <hatbox/disk.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace hatbox {
namespace {

bool is_finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

std::string to_string(const Vec3& v) {
  return "(" + std::to_string(v.x) + ", " + std::to_string(v.y) + ", " + std::to_string(v.z) + ")";
}

void require_valid(const Disk& light) {
  const std::string_view problem = check(light);
  if (problem.empty()) return;
  throw std::invalid_argument(std::string(problem) + "; center " + to_string(light.center) + ", normal " +
                              to_string(light.normal) + ", radius " + std::to_string(light.radius));
}

std::size_t index_of(DiskMap map) {
  const auto index = static_cast<std::size_t>(map);
  if (index >= disk_map_count) throw std::invalid_argument("map: there is no DiskMap " + std::to_string(index));
  return index;
}

float* or_null(std::span<float> array) { return array.empty() ? nullptr : array.data(); }

void run_sample(const Schedule& schedule, const Disk& light, DiskMap map, const Points& points,
                const Variates& variates, const Samples& out) {
  const BatchSize size = checked_size(points, variates);
  check_outputs(out, size.total());
  const std::size_t index = index_of(map);
  require_valid(light);
  const KernelTable& kernels = active_kernels();
  const DiskSampleJob job = {
      .light = disk_constants<float>(light),
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
  run(schedule, size.points, size.per_point, kernels.disk_sample[index], job);
}

/// The job of any query: `query` are its spans, `out` its outputs. All are checked.
DiskQueryJob query_job(const Disk& light, const Points& points, BatchSize size, std::span<const float> query0,
                       std::span<const float> query1, std::span<const float> query2, std::span<float> out0,
                       std::span<float> out1) {
  require_valid(light);
  return {
      .light = disk_constants<float>(light),
      .point = {points.x.data(), points.y.data(), points.z.data()},
      .query = {query0.data(), query1.data(), query2.data()},
      .out = {out0.data(), out1.data()},
      .points = size.points,
      .queries_per_point = size.per_point,
  };
}

void run_pdf(const Schedule& schedule, const Disk& light, DiskMap map, const Points& points,
             const Directions& directions, std::span<float> out) {
  const BatchSize size = checked_size(points, directions);
  check_size("out", out, size.total());
  const DiskQueryKernel kernel = active_kernels().disk_pdf_of_direction[index_of(map)];
  run(schedule, size.points, size.per_point, kernel,
      query_job(light, points, size, directions.x, directions.y, directions.z, out, {}));
}

void run_pdf(const Schedule& schedule, const Disk& light, DiskMap map, const Points& points, const Places& places,
             std::span<float> out) {
  const BatchSize size = checked_size(points, places);
  check_size("out", out, size.total());
  const DiskQueryKernel kernel = active_kernels().disk_pdf_of_place[index_of(map)];
  run(schedule, size.points, size.per_point, kernel, query_job(light, points, size, places.s, places.t, {}, out, {}));
}

void run_invert(const Schedule& schedule, const Disk& light, DiskMap map, const Points& points,
                const Directions& directions, std::span<float> u, std::span<float> v) {
  const BatchSize size = checked_size(points, directions);
  check_size("u", u, size.total());
  check_size("v", v, size.total());
  const DiskQueryKernel kernel = active_kernels().disk_invert[index_of(map)];
  run(schedule, size.points, size.per_point, kernel,
      query_job(light, points, size, directions.x, directions.y, directions.z, u, v));
}

void run_solid_angle(const Schedule& schedule, const Disk& light, const Points& points, std::span<float> out) {
  const BatchSize size = {checked_size(points), 1};
  check_size("out", out, size.total());
  run(schedule, size.points, size.per_point, active_kernels().disk_solid_angle,
      query_job(light, points, size, {}, {}, {}, out, {}));
}

Vec3 scaled(const float (&v)[3], float factor) { return {v[0] * factor, v[1] * factor, v[2] * factor}; }

}  // namespace

std::string_view check(const Disk& light) noexcept {
  if (!is_finite(light.center)) return "light.center is not finite";
  if (!is_finite(light.normal)) return "light.normal is not finite";
  if (light.normal.x == 0 && light.normal.y == 0 && light.normal.z == 0) return "light.normal is zero";
  if (!std::isfinite(light.radius)) return "light.radius is not finite";
  if (light.radius <= 0) return "light.radius is not positive";
  return {};
}

Axes axes(const Disk& light) {
  require_valid(light);
  const DiskConstants constants = disk_constants<float>(light);
  return {scaled(constants.axes[0], light.radius), scaled(constants.axes[1], light.radius)};
}

void sample(const Disk& light, DiskMap map, Points points, Variates variates, Samples out) {
  run_sample({}, light, map, points, variates, out);
}

void pdf(const Disk& light, DiskMap map, Points points, Directions directions, std::span<float> out) {
  run_pdf({}, light, map, points, directions, out);
}

void pdf(const Disk& light, DiskMap map, Points points, Places places, std::span<float> out) {
  run_pdf({}, light, map, points, places, out);
}

void invert(const Disk& light, DiskMap map, Points points, Directions directions, std::span<float> u,
            std::span<float> v) {
  run_invert({}, light, map, points, directions, u, v);
}

void solid_angle(const Disk& light, Points points, std::span<float> out) { run_solid_angle({}, light, points, out); }

namespace parallel {

void sample(const Disk& light, DiskMap map, Points points, Variates variates, Samples out, std::size_t grain) {
  run_sample({.parallel = true, .grain = grain}, light, map, points, variates, out);
}

void pdf(const Disk& light, DiskMap map, Points points, Directions directions, std::span<float> out,
         std::size_t grain) {
  run_pdf({.parallel = true, .grain = grain}, light, map, points, directions, out);
}

void pdf(const Disk& light, DiskMap map, Points points, Places places, std::span<float> out, std::size_t grain) {
  run_pdf({.parallel = true, .grain = grain}, light, map, points, places, out);
}

void invert(const Disk& light, DiskMap map, Points points, Directions directions, std::span<float> u,
            std::span<float> v, std::size_t grain) {
  run_invert({.parallel = true, .grain = grain}, light, map, points, directions, u, v);
}

void solid_angle(const Disk& light, Points points, std::span<float> out, std::size_t grain) {
  run_solid_angle({.parallel = true, .grain = grain}, light, points, out);
}

}  // namespace parallel
}  // namespace hatbox
