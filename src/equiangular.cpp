// The public calls of the media kit: check the lengths, run the kernel.
#include "arguments.h"
#include "dispatch.h"
#include "schedule.h"

#include <hatbox/equiangular.h>

#include <array>

namespace hatbox {
namespace {

using Components = std::array<std::span<const float>, 3>;

void check_vectors(const std::array<const char*, 3>& names, const Components& vectors, std::size_t expected) {
  for (std::size_t axis = 0; axis < 3; ++axis) check_size(names[axis], vectors[axis], expected);
}

std::size_t checked_size(const Segments& segments) {
  const std::size_t n = segments.x.size();
  check_vectors({"segments.x", "segments.y", "segments.z"}, {segments.x, segments.y, segments.z}, n);
  check_vectors({"segments.dx", "segments.dy", "segments.dz"}, {segments.dx, segments.dy, segments.dz}, n);
  check_size("segments.t_min", segments.t_min, n);
  check_size("segments.t_max", segments.t_max, n);
  return n;
}

SegmentJob job_of(const Segments& segments, const Points& places) {
  SegmentJob job = {};
  job.segments = segments.x.size();
  job.samples_per_segment = 1;
  const Components origin{segments.x, segments.y, segments.z}, direction{segments.dx, segments.dy, segments.dz},
      place{places.x, places.y, places.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    job.origin[axis] = origin[axis].data();
    job.direction[axis] = direction[axis].data();
    job.place[axis] = place[axis].data();
  }
  job.t_min = segments.t_min.data();
  job.t_max = segments.t_max.data();
  return job;
}

/// The job of k numbers a segment, its outputs not yet set.
SegmentJob checked_job(const Segments& segments, const Points& pivots, const char* name, std::span<const float> in) {
  const std::size_t n = checked_size(segments);
  check_vectors({"pivots.x", "pivots.y", "pivots.z"}, {pivots.x, pivots.y, pivots.z}, n);
  SegmentJob job = job_of(segments, pivots);
  job.samples_per_segment = checked_multiple(name, in.size(), n, "segments");
  job.in = in.data();
  return job;
}

void run_sample(const Schedule& schedule, const Segments& segments, const Points& pivots, std::span<const float> u,
                std::span<float> t, std::span<float> pdf) {
  SegmentJob job = checked_job(segments, pivots, "u", u);
  check_size("t", t, u.size());
  check_size("pdf", pdf, u.size());
  job.out[0] = t.data();
  job.out[1] = pdf.data();
  run(schedule, job.segments, job.samples_per_segment, active_kernels().equiangular.sample, job, job.out[0]);
}

void run_pdf(const Schedule& schedule, const Segments& segments, const Points& pivots, std::span<const float> t,
             std::span<float> out) {
  SegmentJob job = checked_job(segments, pivots, "t", t);
  check_size("out", out, t.size());
  job.out[0] = out.data();
  run(schedule, job.segments, job.samples_per_segment, active_kernels().equiangular.pdf, job, job.out[0]);
}

void run_clip(const Schedule& schedule, const Segments& segments, const Points& on_plane, const Directions& normals,
              std::span<float> t_min, std::span<float> t_max) {
  const std::size_t n = checked_size(segments);
  check_vectors({"on_plane.x", "on_plane.y", "on_plane.z"}, {on_plane.x, on_plane.y, on_plane.z}, n);
  check_vectors({"normals.x", "normals.y", "normals.z"}, {normals.x, normals.y, normals.z}, n);
  check_size("t_min", t_min, n);
  check_size("t_max", t_max, n);
  SegmentJob job = job_of(segments, on_plane);
  job.normal[0] = normals.x.data();
  job.normal[1] = normals.y.data();
  job.normal[2] = normals.z.data();
  job.out[0] = t_min.data();
  job.out[1] = t_max.data();
  run(schedule, n, 1, active_kernels().equiangular.clip, job, job.out[0]);
}

}  // namespace

namespace equiangular {

void sample(Segments segments, Points pivots, std::span<const float> u, std::span<float> t, std::span<float> pdf) {
  run_sample({}, segments, pivots, u, t, pdf);
}

void pdf(Segments segments, Points pivots, std::span<const float> t, std::span<float> out) {
  run_pdf({}, segments, pivots, t, out);
}

void clip(Segments segments, Points on_plane, Directions normals, std::span<float> t_min, std::span<float> t_max) {
  run_clip({}, segments, on_plane, normals, t_min, t_max);
}

}  // namespace equiangular

namespace parallel::equiangular {

void sample(Segments segments, Points pivots, std::span<const float> u, std::span<float> t, std::span<float> pdf,
            std::size_t grain) {
  run_sample(parallel_with(grain), segments, pivots, u, t, pdf);
}

void pdf(Segments segments, Points pivots, std::span<const float> t, std::span<float> out, std::size_t grain) {
  run_pdf(parallel_with(grain), segments, pivots, t, out);
}

void clip(Segments segments, Points on_plane, Directions normals, std::span<float> t_min, std::span<float> t_max,
          std::size_t grain) {
  run_clip(parallel_with(grain), segments, on_plane, normals, t_min, t_max);
}

}  // namespace parallel::equiangular
}  // namespace hatbox
