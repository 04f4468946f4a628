#include "light_bench.h"

#include "arrays.h"
#include "reference/sph_quad.h"

#include <hatbox/hatbox.h>

#include <benchmark/benchmark.h>

#include <cstddef>
#include <functional>
#include <string>
#include <utility>

namespace hatbox::bench {
namespace {

constexpr Ellipse ellipse{{0, 0, 0}, {1, 0, 0}, {0, 0.5f, 0}};
constexpr Rectangle rectangle{{-0.5f, -0.5f, 0}, {1, 0, 0}, {0, 1, 0}};
constexpr Triangle triangle{{-0.5f, -0.25f, 0}, {0.5f, -0.25f, 0}, {-0.5f, 0.75f, 0}};

constexpr std::pair<const char*, EllipseMap> ellipse_maps[] = {
    {"area", EllipseMap::area}, {"ld_radial", EllipseMap::ld_radial}, {"radial", EllipseMap::radial}};
constexpr std::pair<const char*, RectangleMap> rectangle_maps[] = {{"area", RectangleMap::area},
                                                                   {"spherical", RectangleMap::spherical},
                                                                   {"two_triangles", RectangleMap::two_triangles}};
constexpr std::pair<const char*, TriangleMap> triangle_maps[] = {{"area", TriangleMap::area},
                                                                 {"spherical", TriangleMap::spherical}};

class Registry {
 public:
  void add(Case c, const std::function<void(Arrays&)>& work) {
    c.workload = "W1";
    benchmark::RegisterBenchmark(c.name().c_str(), [c, work](benchmark::State& state) {
      Arrays& a = shared_arrays(c.points, c.samples_per_point);
      for ([[maybe_unused]] auto _ : state) {
        work(a);
        benchmark::ClobberMemory();
      }
    })->UseRealTime();
    cases.push_back(std::move(c));
  }

  template <class Light, class Maps>
  void add_maps(const char* name_of_light, const Light& light, const Maps& maps) {
    for (const std::size_t k : {std::size_t{1}, std::size_t{16}}) {
      for (const Isa isa : available_isas()) {
        for (const auto& [map_name, map] : maps) {
          const Case c{.light = name_of_light,
                       .map = map_name,
                       .isa = name(isa),
                       .samples_per_point = k,
                       .points = points_in_cache};
          add(c, [isa, light, map = map](Arrays& a) {
            force_isa(isa);
            sample(light, map, a.points(), a.variates(), a.samples());
          });
        }
      }
    }
  }

  std::vector<Case> cases;
};

/// Listings 1-3 of Ureña et al. 2013 in scalar float, a sample at a time with its set-up, and from the point they give
/// the same outputs as ours.
void sample_by_listings(Arrays& a) {
  using Vector = reference::Vector<float>;
  Rectangle light = rectangle;
  benchmark::DoNotOptimize(light);  // no renderer's light is known to its compiler
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

}  // namespace

std::vector<Case> register_light_cases() {
  Registry registry;
  registry.add_maps("ellipse", ellipse, ellipse_maps);
  registry.add_maps("rectangle", rectangle, rectangle_maps);
  registry.add({.light = "rectangle", .map = "spherical", .isa = "reference", .points = 256}, sample_by_listings);
  registry.add_maps("triangle", triangle, triangle_maps);
  return registry.cases;
}

}  // namespace hatbox::bench
