#include "auto_switch.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

namespace hatbox::bench {
namespace {

constexpr std::size_t block = 512;

/// Those points of a block that are sampled with one map, packed, and what is sampled there.
struct Group {
  std::array<std::uint32_t, block> index;
  std::size_t count = 0;
  std::array<std::vector<float>, 5> in;   // x, y, z; u, v
  std::array<std::vector<float>, 8> out;  // in the order of Samples
};

std::array<std::span<float>, 8> columns(const Samples& s) {
  return {s.x, s.y, s.z, s.distance, s.pdf, s.s, s.t, s.cosine};
}

Samples samples_of(const std::array<std::span<float>, 8>& c) {
  return {c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7]};
}

/// Samples blocks of points of one light, with the scratch it takes.
class Block {
 public:
  Block(const Disk& light, float below) : light_(light) {
    const Vec3& n = light.normal;
    const float length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
    threshold_ = below * length / (std::numbers::pi_v<float> * light.radius * light.radius);
  }

  void sample(const Points& points, const Variates& variates, const Samples& out, std::size_t begin, std::size_t end) {
    sort(points, begin, end);
    const std::size_t n = points.x.size(), k = n == 0 ? 0 : variates.u.size() / n;
    const std::size_t count = end - begin;
    for (const bool far : {false, true}) {
      const DiskMap map = far ? DiskMap::area : DiskMap::ld_radial;
      if (group_[far].count == count && k == 1) {
        sample_in_place(map, points, variates, out, begin, count);
      } else if (group_[far].count > 0) {
        sample_group(group_[far], map, points, variates, out, k);
      }
    }
  }

 private:
  void sample_in_place(DiskMap map, const Points& points, const Variates& variates, const Samples& out,
                       std::size_t begin, std::size_t count) const {
    const auto part = [&](auto all) { return all.empty() ? all : all.subspan(begin, count); };
    auto parts = columns(out);
    for (std::span<float>& column : parts) column = part(column);
    hatbox::sample(light_, map, {part(points.x), part(points.y), part(points.z)}, {part(variates.u), part(variates.v)},
                   samples_of(parts));
  }

  void sort(const Points& points, std::size_t begin, std::size_t end) {
    group_[0].count = group_[1].count = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const float x = light_.center.x - points.x[i], y = light_.center.y - points.y[i],
                  z = light_.center.z - points.z[i];
      const float height = std::abs(x * light_.normal.x + y * light_.normal.y + z * light_.normal.z);
      const float distance2 = x * x + y * y + z * z;
      const bool far = height < threshold_ * distance2 * std::sqrt(distance2);
      Group& group = group_[far];
      group.index[group.count++] = static_cast<std::uint32_t>(i);
    }
  }

  void sample_group(Group& group, DiskMap map, const Points& points, const Variates& variates, const Samples& out,
                    std::size_t k) {
    const std::size_t n = points.x.size(), m = group.count;
    const auto gather = [&](std::span<const float> from, std::vector<float>& to, std::size_t copies) {
      to.resize(m * copies);
      for (std::size_t j = 0; j < copies; ++j) {
        for (std::size_t i = 0; i < m; ++i) to[j * m + i] = from[j * n + group.index[i]];
      }
    };
    gather(points.x, group.in[0], 1);
    gather(points.y, group.in[1], 1);
    gather(points.z, group.in[2], 1);
    gather(variates.u, group.in[3], k);
    gather(variates.v, group.in[4], k);
    const auto wanted = columns(out);
    std::array<std::span<float>, 8> packed;
    for (std::size_t c = 0; c < wanted.size(); ++c) {
      if (wanted[c].empty()) continue;
      group.out[c].resize(m * k);
      packed[c] = group.out[c];
    }
    hatbox::sample(light_, map, {group.in[0], group.in[1], group.in[2]}, {group.in[3], group.in[4]},
                   samples_of(packed));
    for (std::size_t c = 0; c < wanted.size(); ++c) {
      if (wanted[c].empty()) continue;
      for (std::size_t j = 0; j < k; ++j) {
        for (std::size_t i = 0; i < m; ++i) wanted[c][j * n + group.index[i]] = packed[c][j * m + i];
      }
    }
  }

  const Disk light_;
  float threshold_;  // of |height|/distance³
  Group group_[2];   // near, far
};

}  // namespace

void sample_auto(const Disk& light, float below, const Points& points, const Variates& variates, const Samples& out) {
  Block work(light, below);
  const std::size_t n = points.x.size();
  for (std::size_t i = 0; i < n; i += block) work.sample(points, variates, out, i, std::min(n, i + block));
}

void parallel::sample_auto(const Disk& light, float below, const Points& points, const Variates& variates,
                           const Samples& out) {
  const std::size_t n = points.x.size();
  tbb::enumerable_thread_specific<Block> work(light, below);  // one a thread, for its scratch
  tbb::parallel_for(std::size_t{0}, (n + block - 1) / block, [&](std::size_t i) {
    work.local().sample(points, variates, out, i * block, std::min(n, (i + 1) * block));
  });
}

}  // namespace hatbox::bench
