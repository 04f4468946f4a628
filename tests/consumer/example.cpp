#include <hatbox/hatbox.h>

#include <cstdio>
#include <vector>

int main() {
  const hatbox::Disk light{.center = {0, 0, 3}, .normal = {0, 0, -1}, .radius = 1};
  const std::vector<float> px{-1, 0, 1, 2}, py{0, 0, 0, 0}, pz{0, 0, 0, 0};       // shading points
  const std::vector<float> u{0.1f, 0.3f, 0.5f, 0.7f}, v{0.8f, 0.6f, 0.4f, 0.2f};  // one sample each
  std::vector<float> x(4), y(4), z(4), distance(4), pdf(4);
  hatbox::sample(light, hatbox::DiskMap::ld_radial, {px, py, pz}, {u, v}, {x, y, z, distance, pdf});
  for (int i = 0; i < 4; ++i)
    std::printf("%g %g %g at %g, pdf %g per steradian\n", x[i], y[i], z[i], distance[i], pdf[i]);
}
