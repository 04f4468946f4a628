#include "rectangle_bench.h"

#include "arrays.h"
#include "reference/sph_quad.h"

#include <hatbox/hatbox.h>

#include <benchmark/benchmark.h>

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>

namespace hatbox::bench {
namespace {

constexpr Rectangle light{{-0.5f, -0.5f, 0}, {1, 0, 0}, {0, 1, 0}};
constexpr std::size_t in_cache = 4096;
constexpr std::pair<const char*, RectangleMap> maps[] = {{"area", RectangleMap::area},
                                                         {"two_triangles", RectangleMap::two_triangles},
                                                         {"spherical", RectangleMap::spherical}};

/// Made once for each number of samples a point and shared by all cases.
Arrays& arrays(const Case& c) {
  static std::map<std::pair<std::size_t, std::size_t>, std::unique_ptr<Arrays>> all;
  std::unique_ptr<Arrays>& one = all[{c.points, c.samples_per_point}];
  if (!one) one = std::make_unique<Arrays>(c.points, c.samples_per_point);
  return *one;
}

/// Listings 1-3 of Ureña et al. 2013 in scalar float, a sample at a time with its set-up, and from the point they give
/// the same outputs as ours.
void sample_by_listings(Arrays& a) {
  using Vector = reference::Vector<float>;
  const auto corner = reference::convert<float>(light.corner), edge_u = reference::convert<float>(light.edge_u),
             edge_v = reference::convert<float>(light.edge_v);
  const Points p = a.points();
  const Variates variates = a.variates();
  const Samples out = a.samples();
  for (std::size_t i = 0; i < a.point_count(); ++i) {
    const Vector point = {p.x[i], p.y[i], p.z[i]};
    const reference::SphQuad<float> quad(corner, edge_u, edge_v, point);
    const Vector way = quad.sample(variates.u[i], variates.v[i]) - point;
    const float distance = length(way);
    out.x[i] = way.x / distance;
    out.y[i] = way.y / distance;
    out.z[i] = way.z / distance;
    out.distance[i] = distance;
    out.pdf[i] = 1 / quad.S;
  }
}

class Registry {
 public:
  void add(Case c, const std::function<void(Arrays&)>& work) {
    c.light = "rectangle";
    c.workload = "W1";
    benchmark::RegisterBenchmark(c.name().c_str(), [c, work](benchmark::State& state) {
      Arrays& a = arrays(c);
      for (auto _ : state) {
        work(a);
        benchmark::ClobberMemory();
      }
    })->UseRealTime();
    cases.push_back(std::move(c));
  }

  std::vector<Case> cases;
};

}  // namespace

std::vector<Case> register_rectangle_cases() {
  Registry registry;
  for (const std::size_t k : {std::size_t{1}, std::size_t{16}}) {
    for (const Isa isa : available_isas()) {
      for (const auto& [map_name, map] : maps) {
        const Case c{.map = map_name, .isa = name(isa), .samples_per_point = k, .points = in_cache};
        registry.add(c, [isa, map = map](Arrays& a) {
          force_isa(isa);
          sample(light, map, a.points(), a.variates(), a.samples());
        });
      }
    }
  }
  registry.add({.map = "spherical", .isa = "reference", .points = 256}, sample_by_listings);
  return registry.cases;
}

}  // namespace hatbox::bench
