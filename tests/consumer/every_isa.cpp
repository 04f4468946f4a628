// A program for the oldest CPU of its platform asks every instruction set there is for the same samples: it is told the
// same numbers, but for a last place of sse4_2 now and then.
#include <hatbox/hatbox.h>

#include <cmath>
#include <cstdio>
#include <string_view>
#include <vector>

static_assert(std::string_view(HATBOX_VERSION) == EXPECTED_VERSION);  // the package's

namespace {

constexpr std::size_t n = 1000;

std::vector<float> multiples_of(float step, float low, float high) {
  std::vector<float> out(n);
  for (std::size_t i = 0; i < n; ++i) {
    const float x = static_cast<float>(i) * step;
    out[i] = low + (high - low) * (x - std::floor(x));
  }
  return out;
}

std::vector<float> distances() {
  const hatbox::Disk light{.center = {0, 0, 3}, .normal = {0, 0, -1}, .radius = 1};
  const std::vector<float> px = multiples_of(0.618034f, -3, 3), py = multiples_of(0.754878f, -3, 3),
                           pz = multiples_of(0.569840f, 0, 2.9f);
  const std::vector<float> u = multiples_of(0.414214f, 0, 1), v = multiples_of(0.732051f, 0, 1);
  std::vector<float> x(n), y(n), z(n), distance(n), pdf(n);
  hatbox::sample(light, hatbox::DiskMap::ld_radial, {px, py, pz}, {u, v}, {x, y, z, distance, pdf});
  return distance;
}

}  // namespace

int main() {
  hatbox::force_isa(hatbox::Isa::scalar);
  const std::vector<float> expected = distances();
  int wrong = 0;
  for (const hatbox::Isa isa : hatbox::available_isas()) {
    hatbox::force_isa(isa);
    const std::vector<float> got = distances();
    const float tolerance = isa == hatbox::Isa::sse4_2 ? 1e-6f : 0.0f;
    int bad = 0;
    for (std::size_t i = 0; i < n; ++i)
      if (!(expected[i] > 0) || !(std::abs(got[i] - expected[i]) <= tolerance * expected[i])) ++bad;
    std::printf("%s: %d of %zu differ\n", hatbox::name(hatbox::active_isa()), bad, n);
    wrong += bad + (hatbox::active_isa() != isa);
  }
  return wrong == 0 ? 0 : 1;
}
