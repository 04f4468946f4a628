#include "support/light_sets.h"

#include "support/frames.h"

#include <memory>

namespace hatbox::test {

MixedLights::MixedLights(Pose pose, std::size_t of_each_kind) {
  Random random(7);
  const auto center = [&] { return moved(pose, {random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(0, 3)}); };
  for (std::size_t i = 0; i < of_each_kind; ++i) {
    const double size = random.log_uniform(0.01, 3), aspect = random.log_uniform(0.02, 50);
    const Frame frame = random_frame(random);
    const Vec3 u = rounded(size * frame.u), v = rounded(size * aspect * frame.v);
    disks.push_back({center(), rounded(frame.n), static_cast<float>(size)});
    ellipses.push_back({center(), u, v});
    rectangles.push_back({center(), u, v});
    const Vec3 a = center(), slanted = rounded(size * frame.u + size * aspect * frame.v);
    triangles.push_back({a, {a.x + u.x, a.y + u.y, a.z + u.z}, {a.x + slanted.x, a.y + slanted.y, a.z + slanted.z}});
  }
}

Sampler MixedLights::alone(std::size_t index, const LightSet::Maps& maps) const {
  const std::string name = "light " + std::to_string(index);
  if (index < disks.size()) return Sampler(name, disks[index], maps.disk);
  index -= disks.size();
  if (index < ellipses.size()) return Sampler(name, ellipses[index], maps.ellipse);
  index -= ellipses.size();
  if (index < rectangles.size()) return Sampler(name, rectangles[index], maps.rectangle);
  return Sampler(name, triangles[index - rectangles.size()], maps.triangle);
}

std::vector<std::uint32_t> random_choices(std::size_t n, std::size_t lights) {
  Random random(8);
  std::vector<std::uint32_t> chosen;
  for (std::size_t i = 0; i < n; ++i) {
    chosen.push_back(static_cast<std::uint32_t>(random.unit() * static_cast<double>(lights)));
  }
  return chosen;
}

Sampler sampler_of(const LightSet& set, const std::vector<std::uint32_t>& chosen) {
  const auto workspace = std::make_shared<Workspace>();
  Sampler sampler;
  sampler.name = "set of " + std::to_string(set.size());
  sampler.sample = [=](const Points& points, const Variates& variates, const Samples& out, Grain grain) {
    grain ? parallel::sample(set, chosen, points, variates, out, *workspace, *grain)
          : hatbox::sample(set, chosen, points, variates, out, *workspace);
  };
  sampler.pdf_of_direction = [=](const Points& points, const Directions& of, std::span<float> out, Grain grain) {
    grain ? parallel::pdf(set, chosen, points, of, out, *workspace, *grain)
          : hatbox::pdf(set, chosen, points, of, out, *workspace);
  };
  sampler.pdf_of_place = [=](const Points& points, const Places& of, std::span<float> out, Grain grain) {
    grain ? parallel::pdf(set, chosen, points, of, out, *workspace, *grain)
          : hatbox::pdf(set, chosen, points, of, out, *workspace);
  };
  sampler.invert = [=](const Points& points, const Directions& of, std::span<float> u, std::span<float> v,
                       Grain grain) {
    grain ? parallel::invert(set, chosen, points, of, u, v, *workspace, *grain)
          : hatbox::invert(set, chosen, points, of, u, v, *workspace);
  };
  sampler.solid_angle = [=](const Points& points, std::span<float> out, Grain grain) {
    grain ? parallel::solid_angle(set, chosen, points, out, *workspace, *grain)
          : hatbox::solid_angle(set, chosen, points, out, *workspace);
  };
  return sampler;
}

}  // namespace hatbox::test
