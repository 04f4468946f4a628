#include "equiangular_bench.h"

#include "arrays.h"

#include <hatbox/hatbox.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace hatbox::bench {
namespace {

/// Rays from the points of W1 to random directions, of lengths 0.1 to 10, about the light's centre.
struct Rays {
  Rays(std::size_t n, std::size_t k) : arrays(n, k), pivot(n, 0), t(n * k), pdf(n * k) {
    Random random;
    for (std::size_t i = 0; i < n; ++i) {
      const float z = random(-1, 1), phi = random(0, 6.2831853f), ring = std::sqrt(1 - z * z);
      dx.push_back(ring * std::cos(phi));
      dy.push_back(ring * std::sin(phi));
      dz.push_back(z);
      t_min.push_back(random(0, 1));
      t_max.push_back(t_min.back() + random(0.1f, 10));
    }
  }

  Segments segments() const {
    const Points p = arrays.points();
    return {p.x, p.y, p.z, dx, dy, dz, t_min, t_max};
  }

  Arrays arrays;
  std::vector<float> dx, dy, dz, t_min, t_max, pivot, t, pdf;
};

Rays& rays(const Case& c) {
  static std::map<std::pair<std::size_t, std::size_t>, std::unique_ptr<Rays>> all;
  std::unique_ptr<Rays>& one = all[{c.points, c.samples_per_point}];
  if (!one) one = std::make_unique<Rays>(c.points, c.samples_per_point);
  return *one;
}

/// The form that is in every renderer, in double, a sample at a time (Kulla and Fajardo 2012).
void sample_as_published(Rays& r) {
  const Segments s = r.segments();
  const Variates variates = r.arrays.variates();
  for (std::size_t i = 0; i < s.x.size(); ++i) {
    const double w[] = {-static_cast<double>(s.x[i]), -static_cast<double>(s.y[i]), -static_cast<double>(s.z[i])};
    const double d[] = {s.dx[i], s.dy[i], s.dz[i]};
    const double foot = w[0] * d[0] + w[1] * d[1] + w[2] * d[2];
    const double distance = std::sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2] - foot * foot);
    const double from = std::atan((static_cast<double>(s.t_min[i]) - foot) / distance);
    const double to = std::atan((static_cast<double>(s.t_max[i]) - foot) / distance);
    const double x = distance * std::tan(from + static_cast<double>(variates.u[i]) * (to - from));
    r.t[i] = static_cast<float>(foot + x);
    r.pdf[i] = static_cast<float>(distance / ((to - from) * (distance * distance + x * x)));
  }
}

template <class Work>
Case add_case(const Case& like, const char* isa, const Work& work) {
  Case c = like;
  c.isa = isa;
  benchmark::RegisterBenchmark(c.name().c_str(), [c, work](benchmark::State& state) {
    Rays& r = rays(c);
    for ([[maybe_unused]] auto _ : state) {
      work(r);
      benchmark::ClobberMemory();
    }
  })->UseRealTime();
  return c;
}

}  // namespace

std::vector<Case> register_equiangular_cases() {
  std::vector<Case> cases;
  for (const std::size_t k : {std::size_t{1}, std::size_t{16}}) {
    const Case base{.light = "segment", .map = "equiangular", .workload = "W1", .samples_per_point = k, .points = 4096};
    for (const Isa isa : available_isas()) {
      cases.push_back(add_case(base, name(isa), [isa](Rays& r) {
        force_isa(isa);
        const Points pivots{r.pivot, r.pivot, r.pivot};
        equiangular::sample(r.segments(), pivots, r.arrays.variates().u, r.t, r.pdf);
      }));
    }
  }
  const Case base{.light = "segment", .map = "equiangular", .workload = "W1", .points = 4096};
  cases.push_back(add_case(base, "reference", sample_as_published));
  return cases;
}

}  // namespace hatbox::bench
