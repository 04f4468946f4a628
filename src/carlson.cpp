// The public calls of the elliptic integrals: check the lengths, run the kernel.
#include "arguments.h"
#include "dispatch.h"
#include "schedule.h"

#include <hatbox/carlson.h>

#include <array>

namespace hatbox {
namespace {

struct Argument {
  const char* name;
  std::span<const float> values;
};

template <std::size_t count>
void run_carlson(const Schedule& schedule, CarlsonKernel CarlsonKernels::*kernel,
                 const std::array<Argument, count>& arguments, std::span<float> out) {
  const std::size_t n = arguments[0].values.size();
  CarlsonJob job = {.in = {}, .out = out.data()};
  for (std::size_t i = 0; i < count; ++i) {
    check_size(arguments[i].name, arguments[i].values, n);
    job.in[i] = arguments[i].values.data();
  }
  check_size("out", out, n);
  run(schedule, n, 1, active_kernels().carlson.*kernel, job, job.out);
}

using Values = std::span<const float>;

void run_rf(const Schedule& schedule, Values x, Values y, Values z, std::span<float> out) {
  run_carlson<3>(schedule, &CarlsonKernels::rf, {{{"x", x}, {"y", y}, {"z", z}}}, out);
}

void run_rc(const Schedule& schedule, Values x, Values y, std::span<float> out) {
  run_carlson<2>(schedule, &CarlsonKernels::rc, {{{"x", x}, {"y", y}}}, out);
}

void run_rd(const Schedule& schedule, Values x, Values y, Values z, std::span<float> out) {
  run_carlson<3>(schedule, &CarlsonKernels::rd, {{{"x", x}, {"y", y}, {"z", z}}}, out);
}

void run_rj(const Schedule& schedule, Values x, Values y, Values z, Values p, std::span<float> out) {
  run_carlson<4>(schedule, &CarlsonKernels::rj, {{{"x", x}, {"y", y}, {"z", z}, {"p", p}}}, out);
}

void run_f(const Schedule& schedule, Values phi, Values m, std::span<float> out) {
  run_carlson<2>(schedule, &CarlsonKernels::ellint_f, {{{"phi", phi}, {"m", m}}}, out);
}

void run_e(const Schedule& schedule, Values phi, Values m, std::span<float> out) {
  run_carlson<2>(schedule, &CarlsonKernels::ellint_e, {{{"phi", phi}, {"m", m}}}, out);
}

void run_pi(const Schedule& schedule, Values n, Values phi, Values m, std::span<float> out) {
  run_carlson<3>(schedule, &CarlsonKernels::ellint_pi, {{{"n", n}, {"phi", phi}, {"m", m}}}, out);
}

}  // namespace

void carlson_rf(Values x, Values y, Values z, std::span<float> out) { run_rf({}, x, y, z, out); }
void carlson_rc(Values x, Values y, std::span<float> out) { run_rc({}, x, y, out); }
void carlson_rd(Values x, Values y, Values z, std::span<float> out) { run_rd({}, x, y, z, out); }
void carlson_rj(Values x, Values y, Values z, Values p, std::span<float> out) { run_rj({}, x, y, z, p, out); }
void ellint_f(Values phi, Values m, std::span<float> out) { run_f({}, phi, m, out); }
void ellint_e(Values phi, Values m, std::span<float> out) { run_e({}, phi, m, out); }
void ellint_pi(Values n, Values phi, Values m, std::span<float> out) { run_pi({}, n, phi, m, out); }

namespace parallel {

void carlson_rf(Values x, Values y, Values z, std::span<float> out, std::size_t grain) {
  run_rf(parallel_with(grain), x, y, z, out);
}
void carlson_rc(Values x, Values y, std::span<float> out, std::size_t grain) {
  run_rc(parallel_with(grain), x, y, out);
}
void carlson_rd(Values x, Values y, Values z, std::span<float> out, std::size_t grain) {
  run_rd(parallel_with(grain), x, y, z, out);
}
void carlson_rj(Values x, Values y, Values z, Values p, std::span<float> out, std::size_t grain) {
  run_rj(parallel_with(grain), x, y, z, p, out);
}
void ellint_f(Values phi, Values m, std::span<float> out, std::size_t grain) {
  run_f(parallel_with(grain), phi, m, out);
}
void ellint_e(Values phi, Values m, std::span<float> out, std::size_t grain) {
  run_e(parallel_with(grain), phi, m, out);
}
void ellint_pi(Values n, Values phi, Values m, std::span<float> out, std::size_t grain) {
  run_pi(parallel_with(grain), n, phi, m, out);
}

}  // namespace parallel
}  // namespace hatbox
