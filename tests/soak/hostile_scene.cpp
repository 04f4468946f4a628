#include "soak/hostile_scene.h"

#include "reference/vector.h"
#include "support/disk_maps.h"
#include "support/ellipses.h"
#include "support/light_sets.h"
#include "support/rectangles.h"
#include "support/triangle_lights.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace hatbox::test {
namespace {

using Vector = reference::Vector<double>;

Vec3 rounded(const Vector& v) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)}; }

double signed_log_uniform(Random& random, double low, double high) {
  const double size = random.log_uniform(low, high);
  return random.unit() < 0.5 ? -size : size;
}

/// Where the lights are: their common corner or centre, axes and sizes.
struct Frame {
  Vector origin{0, 0, 0}, u{1, 0, 0}, v{0, 1, 0}, n{0, 0, 1};
  double size = 1, aspect = 1;

  Vector at(double along_u, double along_v, double along_n) const {
    return origin + size * (along_u * u + along_v * v + along_n * n);
  }
};

Frame random_frame(Random& random) {
  Frame frame;
  if (random.unit() < 0.75) frame.size = random.log_uniform(1e-12, 1e12);
  frame.aspect = random.log_uniform(1e-3, 1);
  if (random.unit() < 0.5) {
    const auto far = [&] { return frame.size * signed_log_uniform(random, 1e-3, 1e3); };
    frame.origin = {far(), far(), far()};
  }
  if (random.unit() < 0.5) {
    const double z = random.uniform(-1, 1), ring = std::sqrt(1 - z * z), phi = 2 * std::numbers::pi * random.unit();
    frame.n = {ring * std::cos(phi), ring * std::sin(phi), z};
    frame.u = {-std::sin(phi), std::cos(phi), 0};
    frame.v = cross(frame.n, frame.u);
  }
  return frame;
}

Vec3 hostile_point(Random& random, const Frame& frame, std::size_t kind) {
  const auto any = [&](double low, double high) { return signed_log_uniform(random, low, high); };
  const double angle = 2 * std::numbers::pi * random.unit(), rim = 1 + any(1e-8, 0.1);
  switch (kind % 8) {
    case 0: return rounded(frame.at(any(1e-30, 1e18), any(1e-30, 1e18), any(1e-30, 1e18)));
    case 1: return rounded(frame.at(rim * std::cos(angle), rim * std::sin(angle), any(1e-30, 0.1)));
    case 2: return rounded(frame.at(random.uniform(-1, 1), random.uniform(-1, 1), any(1e-38, 1)));
    case 3: return rounded(frame.at(any(1e-30, 1), any(1e-30, 1), any(1e-10, 1e10)));
    case 4: return rounded(frame.at(any(1, 1e18), any(1, 1e18), any(1e-20, 1e18)));
    case 5: return rounded(frame.at(random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)));
    case 6: return rounded(frame.at(random.uniform(-2, 2), std::round(random.uniform(-2, 2)), 0));
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
                           std::numeric_limits<float>::infinity(),
                           std::numeric_limits<float>::quiet_NaN()};
  if (i % 16 != 0) return static_cast<float>(random.unit());
  return odd[static_cast<std::size_t>(random.unit() * std::size(odd))];
}

template <class Maps, class Light>
void add(std::vector<Sampler>& samplers, const std::string& kind, const Light& light, const Maps& maps) {
  for (const auto map : maps) samplers.emplace_back(kind + " " + name(map), light, map);
}

}  // namespace

HostileScene::HostileScene(std::uint64_t number, std::size_t size) {
  Random random(static_cast<std::uint32_t>(number * 2654435761u + 1));
  const Frame frame = random_frame(random);
  const Vec3 u = rounded(frame.size * frame.u), v = rounded(frame.size * frame.aspect * frame.v);
  const Disk disk{rounded(frame.origin), rounded(frame.n), static_cast<float>(frame.size)};
  const Ellipse ellipse{rounded(frame.origin), u, v};
  const Rectangle rectangle{rounded(frame.origin), u, v};
  const Triangle triangle{rounded(frame.origin), rounded(frame.at(1, 0, 0)),
                          rounded(frame.at(random.uniform(-1, 1), frame.aspect, 0))};
  add(samplers, "disk", disk, all_disk_maps);
  add(samplers, "ellipse", ellipse, all_ellipse_maps);
  add(samplers, "rectangle", rectangle, all_rectangle_maps);
  if (check(triangle).empty()) add(samplers, "triangle", triangle, all_triangle_maps);
  const std::vector<Triangle> triangles(check(triangle).empty() ? 1u : 0u, triangle);
  const LightSet set(std::span(&disk, 1), std::span(&ellipse, 1), std::span(&rectangle, 1), triangles);
  samplers.push_back(sampler_of(set, random_choices(size, set.size())));
  samplers.back().name = "set";
  for (std::size_t i = 0; i < size; ++i) {
    points.push_back(hostile_point(random, frame, i));
    variates.u.push_back(hostile_variate(random, i / 8));
    variates.v.push_back(hostile_variate(random, i / 8 + 5));
  }
}

}  // namespace hatbox::test
