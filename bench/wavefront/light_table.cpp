#include "light_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace wavefront {
namespace {

constexpr auto no_light = ~std::uint32_t{0};

/// The concentric map of the square to the unit disk (Shirley and Chiu 1997).
Sample2 concentric(Sample2 sample) {
  const float a = 2 * sample.x - 1, b = 2 * sample.y - 1;
  if (a == 0 && b == 0) return {0, 0};
  constexpr float quarter = std::numbers::pi_v<float> / 4;
  const bool wide = std::abs(a) > std::abs(b);
  const float radius = wide ? a : b;
  const float angle = wide ? quarter * (b / a) : 2 * quarter - quarter * (a / b);
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// The square to the triangle, with little distortion (Heitz 2019).
Sample2 fold(Sample2 sample) {
  const float half = 0.5f * std::min(sample.x, sample.y);
  return sample.x < sample.y ? Sample2{half, sample.y - half} : Sample2{sample.x - half, half};
}

}  // namespace

float luminance(const Rgb& colour) { return 0.2126f * colour.x + 0.7152f * colour.y + 0.0722f * colour.z; }

V3f LightFacts::place(Sample2 sample) const {
  if (domain == Domain::disk) sample = concentric(sample);
  if (domain == Domain::triangle) sample = fold(sample);
  return origin + u * sample.x + v * sample.y;
}

/// Numbers go by kind, as hatbox has them.
LightTable::LightTable(const Scene& scene) : by_emitter_(scene.emitters.size()) {
  for (std::size_t kind = 0; kind < std::variant_size_v<Light>; ++kind)
    for (std::size_t i = 0; i < scene.emitters.size(); ++i) {
      if (scene.emitters[i].light.index() != kind) continue;
      emitter_ = &scene.emitters[i];
      const auto first = static_cast<std::uint32_t>(facts_.size());
      std::visit([&](const auto& light) { add(light); }, emitter_->light);
      const auto* mesh = std::get_if<MeshLight>(&emitter_->light);
      by_emitter_[i].assign(mesh ? mesh->of_mesh.back() + 1 : 1, mesh ? no_light : first);
      if (!mesh) continue;
      for (std::uint32_t t = 0; t < mesh->of_mesh.size(); ++t) by_emitter_[i][mesh->of_mesh[t]] = first + t;
    }
}

std::optional<std::uint32_t> LightTable::find(std::size_t emitter, std::uint32_t triangle) const {
  const auto& lights = by_emitter_[emitter];
  if (facts_[lights.back()].domain != LightFacts::Domain::triangle) return lights.front();
  if (triangle >= lights.size() || lights[triangle] == no_light) return {};
  return lights[triangle];
}

void LightTable::add(const hatbox::Disk& disk) {
  disks_.push_back(disk);
  const hatbox::Axes axes = hatbox::axes(disk);
  add_facts(LightFacts::Domain::disk, to_v3f(disk.center), to_v3f(axes.u), to_v3f(axes.v));
}

void LightTable::add(const hatbox::Ellipse& ellipse) {
  ellipses_.push_back(ellipse);
  add_facts(LightFacts::Domain::disk, to_v3f(ellipse.center), to_v3f(ellipse.semi_axis_u), to_v3f(ellipse.semi_axis_v));
}

void LightTable::add(const hatbox::Rectangle& rectangle) {
  rectangles_.push_back(rectangle);
  add_facts(LightFacts::Domain::square, to_v3f(rectangle.corner), to_v3f(rectangle.edge_u), to_v3f(rectangle.edge_v));
}

void LightTable::add(const MeshLight& mesh) {
  for (const hatbox::Triangle& triangle : mesh.triangles) {
    triangles_.push_back(triangle);
    const V3f a = to_v3f(triangle.a);
    add_facts(LightFacts::Domain::triangle, a, to_v3f(triangle.b) - a, to_v3f(triangle.c) - a);
  }
}

void LightTable::add_facts(LightFacts::Domain domain, const V3f& origin, const V3f& u, const V3f& v) {
  constexpr float area_of_domain[] = {std::numbers::pi_v<float>, 1, 0.5f};
  constexpr float centre_of_domain[] = {0, 0.5f, 1 / 3.0f};
  const auto index = static_cast<std::size_t>(domain);
  const V3f normal = u.cross(v);
  const Rgb& radiance = emitter_->radiance;
  facts_.push_back({domain, origin, u, v, radiance, emitter_->double_sided, origin + (u + v) * centre_of_domain[index],
                    normal.normalized(), normal.length() * area_of_domain[index], luminance(radiance)});
}

}  // namespace wavefront
