// Direct light on a floor, the way a wavefront renderer asks for it: every shading point chooses a light, one call
// samples them all, and what is left is a loop over arrays.
#include <hatbox/hatbox.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <random>
#include <vector>

namespace {

constexpr float pi = 3.14159265f;
constexpr std::size_t width = 24, height = 12, samples = 256;  // of the picture, and of each of its pixels

struct Queue {  // n shading points of the floor z = 0, a sample each
  explicit Queue(std::size_t n)
      : light(n), px(n), py(n), pz(n), u(n), v(n), x(n), y(n), z(n), distance(n), pdf(n), cosine(n) {}

  std::vector<std::uint32_t> light;
  std::vector<float> px, py, pz, u, v;                // in
  std::vector<float> x, y, z, distance, pdf, cosine;  // out
};

}  // namespace

int main() {
  // The lights, all emitting downwards. Index 0 is the disk, then the ellipse, the rectangle and the triangle.
  const hatbox::Disk disks[] = {{.center = {-4, 2, 2}, .normal = {0, 0, -1}, .radius = 1}};
  const hatbox::Ellipse ellipses[] = {{.center = {4, 2, 2}, .semi_axis_u = {0, 2, 0}, .semi_axis_v = {0.5f, 0, 0}}};
  const hatbox::Rectangle rectangles[] = {{.corner = {-4, -3, 1}, .edge_u = {0, 1, 0}, .edge_v = {2, 0, 0}}};
  const hatbox::Triangle triangles[] = {{.a = {2, -3, 1}, .b = {3, -1, 1}, .c = {4, -3, 1}}};
  const float radiance[] = {8, 6, 5, 5};
  const hatbox::LightSet lights(disks, ellipses, rectangles, triangles);
  hatbox::Workspace workspace;  // scratch memory, to be used again and again

  std::mt19937 engine{1};
  const auto random = [&] { return static_cast<float>(engine() >> 8) * 0x1p-24f; };
  constexpr std::size_t n = width * height;
  std::vector<float> radiosity(n);
  Queue q(n);
  for (std::size_t pass = 0; pass < samples; ++pass) {
    for (std::size_t i = 0; i < n; ++i) {
      q.px[i] = (static_cast<float>(i % width) + random()) / width * 12 - 6;
      q.py[i] = 4 - (static_cast<float>(i / width) + random()) / height * 8;
      q.light[i] = static_cast<std::uint32_t>(random() * static_cast<float>(lights.size()));
      q.u[i] = random();
      q.v[i] = random();
    }
    hatbox::parallel::sample(lights, q.light, {q.px, q.py, q.pz}, {q.u, q.v},
                             {.x = q.x, .y = q.y, .z = q.z, .distance = q.distance, .pdf = q.pdf, .cosine = q.cosine},
                             workspace);
    for (std::size_t i = 0; i < n; ++i) {
      if (!(q.pdf[i] > 0) || !(q.cosine[i] > 0)) continue;  // no such sample, or seen from behind
      // Here a renderer traces the shadow ray (q.x, q.y, q.z) as far as q.distance.
      const float probability = q.pdf[i] / static_cast<float>(lights.size());
      radiosity[i] += radiance[q.light[i]] * std::max(q.z[i], 0.0f) / probability / (pi * samples);
    }
  }

  float brightest = 0;
  for (std::size_t i = 0; i < n; ++i) {
    constexpr char shades[] = " .:-=+*#%@";
    const auto shade = static_cast<std::size_t>(std::clamp(radiosity[i] * 5, 0.0f, 9.0f));
    std::printf("%c%s", shades[shade], i % width == width - 1 ? "\n" : "");
    brightest = std::max(brightest, radiosity[i]);
  }
  return brightest > 1 ? 0 : 1;
}
