// Multiple importance sampling: directions sampled by the light and by the surface, weighed by the balance heuristic.
// What that takes of a light sampler is `pdf`: the density with which it would have picked any direction.
#include <hatbox/hatbox.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

namespace {

constexpr float pi = 3.14159265f;
constexpr std::size_t n = 1 << 15;  // samples of each strategy

/// A light above the origin, where a surface that faces it scatters as Lambert's cosine says.
constexpr hatbox::Disk light{.center = {0, 0, 0.5f}, .normal = {0, 0, -1}, .radius = 2};
constexpr hatbox::DiskMap map = hatbox::DiskMap::ld_radial;

struct Directions {
  std::vector<float> x = std::vector<float>(n), y = x, z = x;
  std::vector<float> by_light = x, by_surface = x;  // the densities with which either strategy picks them
};

struct Variates {
  explicit Variates(unsigned seed) {
    std::mt19937 engine{seed};
    for (std::size_t i = 0; i < n; ++i) {
      u.push_back(static_cast<float>(engine() >> 8) * 0x1p-24f);
      v.push_back(static_cast<float>(engine() >> 8) * 0x1p-24f);
    }
  }
  std::vector<float> u, v;
};

const std::vector<float> origin(1, 0.0f);  // one shading point, n samples

Directions sample_light() {
  const Variates variates(1);
  Directions out;
  std::vector<float> distance(n), cosine(n);
  hatbox::sample(light, map, {origin, origin, origin}, {variates.u, variates.v},
                 {.x = out.x, .y = out.y, .z = out.z, .distance = distance, .pdf = out.by_light, .cosine = cosine});
  for (std::size_t i = 0; i < n; ++i) {
    if (!(cosine[i] > 0)) out.by_light[i] = 0;  // it shines from one side only
    out.by_surface[i] = std::max(out.z[i], 0.0f) / pi;
  }
  return out;
}

Directions sample_surface() {
  const Variates variates(2);
  Directions out;
  for (std::size_t i = 0; i < n; ++i) {
    const float radius = std::sqrt(variates.u[i]), angle = 2 * pi * variates.v[i];
    out.x[i] = radius * std::cos(angle);
    out.y[i] = radius * std::sin(angle);
    out.z[i] = std::sqrt(1 - variates.u[i]);
    out.by_surface[i] = out.z[i] / pi;
  }
  // 0 for those that miss the light. A renderer, which has traced the rays, asks for those that hit.
  hatbox::pdf(light, map, {origin, origin, origin}, hatbox::Directions{out.x, out.y, out.z}, out.by_light);
  return out;
}

struct Estimate {
  double mean, error;
};

/// Of ∫ cos θ over the light, from samples with these densities: `other` is that of the other strategy, or none.
Estimate estimate(const Directions& d, const std::vector<float>& own, const std::vector<float>* other) {
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const bool lit = d.by_light[i] > 0 && own[i] > 0;
    const double density = double{own[i]} + (other != nullptr ? double{(*other)[i]} : 0);
    const double value = lit ? double{std::max(d.z[i], 0.0f)} / density : 0;
    sum += value;
    squares += value * value;
  }
  const double mean = sum / n;
  return {mean, std::sqrt(std::max(squares / n - mean * mean, 0.0) / n)};
}

bool report(const char* strategy, const Estimate& e, double exact) {
  std::printf("%-8s %.5f ± %.5f, exactly %.5f\n", strategy, e.mean, e.error, exact);
  return std::abs(e.mean - exact) <= 4 * e.error + 1e-5;
}

}  // namespace

int main() {
  const double exact = pi * 4 / (4 + 0.25);  // π r²/(r² + h²)
  const Directions of_light = sample_light(), of_surface = sample_surface();
  const Estimate a = estimate(of_light, of_light.by_light, &of_light.by_surface);
  const Estimate b = estimate(of_surface, of_surface.by_surface, &of_surface.by_light);
  bool right = report("light", estimate(of_light, of_light.by_light, nullptr), exact);
  right = report("surface", estimate(of_surface, of_surface.by_surface, nullptr), exact) && right;
  right = report("both", {a.mean + b.mean, std::hypot(a.error, b.error)}, exact) && right;
  return right ? 0 : 1;
}
