#include "soak/hostile_scene.h"

#include "support/disks.h"
#include "support/ellipses.h"
#include "support/light_sets.h"
#include "support/rectangles.h"
#include "support/samplable.h"
#include "support/stand.h"
#include "support/triangle_lights.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace hatbox::test {
namespace {

double signed_log_uniform(Random& random, double low, double high) {
  const double size = random.log_uniform(low, high);
  return random.unit() < 0.5 ? -size : size;
}

Stand random_stand(Random& random) {
  Stand stand;
  if (random.unit() < 0.75) stand.size = random.log_uniform(1e-12, 1e12);
  stand.aspect = random.log_uniform(1e-3, 1);
  if (random.unit() < 0.5) {
    const auto far = [&] { return stand.size * signed_log_uniform(random, 1e-3, 1e3); };
    stand.origin = {far(), far(), far()};
  }
  if (random.unit() < 0.5) stand.axes = random_frame(random);
  return stand;
}

Vec3 hostile_point(Random& random, const Stand& stand, std::size_t kind) {
  const auto any = [&](double low, double high) { return signed_log_uniform(random, low, high); };
  const double angle = 2 * std::numbers::pi * random.unit(), rim = 1 + any(1e-8, 0.1);
  switch (kind % 8) {
    case 0: return rounded(stand.at(any(1e-30, 1e18), any(1e-30, 1e18), any(1e-30, 1e18)));
    case 1: return rounded(stand.at(rim * std::cos(angle), rim * std::sin(angle), any(1e-30, 0.1)));
    case 2: return rounded(stand.at(random.uniform(-1, 1), random.uniform(-1, 1), any(1e-38, 1)));
    case 3: return rounded(stand.at(any(1e-30, 1), any(1e-30, 1), any(1e-10, 1e10)));
    case 4: return rounded(stand.at(any(1, 1e18), any(1, 1e18), any(1e-20, 1e18)));
    case 5: return rounded(stand.at(random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)));
    case 6: return rounded(stand.at(random.uniform(-2, 2), std::round(random.uniform(-2, 2)), 0));
    default: break;
  }
  constexpr float odd[] = {0.0f,
                           -0.0f,
                           1.0f,
                           1e-45f,
                           -1e-39f,
                           3e38f,
                           std::numeric_limits<float>::infinity(),
                           std::numeric_limits<float>::quiet_NaN()};
  const auto pick = [&] { return odd[static_cast<std::size_t>(random.unit() * std::size(odd))]; };
  return {pick(), pick(), pick()};
}

float hostile_variate(Random& random, std::size_t i) {
  constexpr float odd[] = {0.0f,
                           1.0f,
                           0.5f,
                           0x1.fffffep-1f,
                           1e-45f,
                           -0.0f,
                           -1.0f,
                           2.0f,
                           3e38f,
                           std::numeric_limits<float>::infinity(),
                           std::numeric_limits<float>::quiet_NaN()};
  if (i % 16 != 0) return static_cast<float>(random.unit());
  return odd[static_cast<std::size_t>(random.unit() * std::size(odd))];
}

template <class Maps, class Light>
void add(HostileScene& scene, const std::string& kind, const Light& light, const Maps& maps) {
  const Samplable judgement(outline_of(light));
  const auto samplable = [&](double least_height) {
    std::vector<bool> result(scene.points.size());
    for (std::size_t i = 0; i < result.size(); ++i) {
      result[i] =
          Samplable::by(scene.variates.u[i], scene.variates.v[i]) && judgement.from(scene.points[i], least_height);
    }
    return result;
  };
  const std::vector<bool> by_most_maps = samplable(0);
  for (const auto map : maps) {
    scene.samplers.emplace_back(kind + " " + name(map), light, map);
    scene.samplable.push_back(least_height(map) == 0 ? by_most_maps : samplable(least_height(map)));
  }
}

/// The scene's lights as a set, one of them chosen for each point. Each kind's first sampler knows its lanes.
void add_set(HostileScene& scene, const LightSet& set, const std::vector<std::size_t>& sampler_of_kind) {
  const std::vector<std::uint32_t> chosen = random_choices(scene.points.size(), set.size());
  std::vector<bool> samplable(chosen.size());
  for (std::size_t i = 0; i < chosen.size(); ++i) samplable[i] = scene.samplable[sampler_of_kind[chosen[i]]][i];
  scene.samplers.push_back(sampler_of(set, chosen));
  scene.samplers.back().name = "set";
  scene.samplable.push_back(samplable);
}

}  // namespace

HostileScene::HostileScene(std::uint64_t number, std::size_t size) {
  Random random(static_cast<std::uint32_t>(number * 2654435761u + 1));
  const Stand stand = random_stand(random);
  const Disk disk = stand.disk();
  const Ellipse ellipse = stand.ellipse();
  const Rectangle rectangle = stand.rectangle();
  const Triangle triangle = stand.triangle(random.uniform(-1, 1));
  for (std::size_t i = 0; i < size; ++i) {
    points.push_back(hostile_point(random, stand, i));
    variates.u.push_back(hostile_variate(random, i / 8));
    variates.v.push_back(hostile_variate(random, i / 8 + 5));
  }
  std::vector<std::size_t> first_of_kind;
  const auto add_kind = [&](const std::string& kind, const auto& light, const auto& maps) {
    first_of_kind.push_back(samplers.size());
    add(*this, kind, light, maps);
  };
  add_kind("disk", disk, all_disk_maps);
  add_kind("ellipse", ellipse, all_ellipse_maps);
  add_kind("rectangle", rectangle, all_rectangle_maps);
  const std::vector<Triangle> triangles(check(triangle).empty() ? 1u : 0u, triangle);
  if (!triangles.empty()) add_kind("triangle", triangle, all_triangle_maps);
  add_set(*this, LightSet(std::span(&disk, 1), std::span(&ellipse, 1), std::span(&rectangle, 1), triangles),
          first_of_kind);
}

}  // namespace hatbox::test
