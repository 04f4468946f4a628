#include "support/segments.h"

#include "support/random.h"

#include <array>
#include <cmath>

namespace hatbox::test {
namespace {

using reference::Vector;

/// A ray along x from the origin, [t_min, t_max] of it, and a pivot at (foot, off the ray).
struct FlatSegment {
  double t_min, t_max, foot, distance;
};

FlatSegment draw(Situation situation, Random& random) {
  const double length = random.log_uniform(0.01, 100), t_min = random.uniform(0, 2) * length, t_max = t_min + length;
  const double within = random.uniform(t_min, t_max);
  const auto sign = random.unit() < 0.5 ? -1 : 1;
  switch (situation) {
    case Situation::ordinary:
      return {t_min, t_max, t_min + random.uniform(-2, 3) * length, random.uniform(0.1, 2) * length};
    case Situation::far_pivot: {
      const double angle = random.uniform(0, M_PI);
      return {t_min, t_max, within + 1e6 * length * std::cos(angle), 1e6 * length * std::sin(angle)};
    }
    case Situation::short_segment: {
      const double angle = random.uniform(0, M_PI), away = 1e4 * length;
      return {t_min, t_max, t_min + away * std::cos(angle), away * std::sin(angle)};
    }
    case Situation::past_pivot: return {t_min, t_max, within, random.log_uniform(1e-4, 1e-1) * length};
    case Situation::through_pivot: return {t_min, t_max, within, random.log_uniform(1e-7, 1e-4) * length};
    case Situation::in_line:
      return {t_min, t_max, (sign > 0 ? t_max : t_min) + sign * random.log_uniform(1e-3, 1e2) * length,
              random.unit() < 0.5 ? 0 : random.log_uniform(1e-9, 1e-1) * length};
    case Situation::at_an_end: return {t_min, t_max, sign > 0 ? t_max : t_min, random.log_uniform(1e-4, 1) * length};
    default: {  // the ray starts far from both, and they are close to each other
      const double away = random.log_uniform(1e1, 1e4) * length;
      return {away, away + length, away + random.uniform(-1, 2) * length, random.log_uniform(0.01, 1) * length};
    }
  }
}

}  // namespace

void SegmentArrays::push_back(const reference::Segment& s, const Vec3& at) {
  origin.push_back(s.origin);
  direction.push_back(s.direction);
  pivot.push_back(at);
  t_min.push_back(s.t_min);
  t_max.push_back(s.t_max);
}

SegmentArrays SegmentArrays::pick(std::span<const std::size_t> indices) const {
  SegmentArrays result;
  for (const std::size_t i : indices) result.push_back(segment(i), pivot[i]);
  return result;
}

const char* name(Situation situation) {
  constexpr std::array names{"ordinary",      "far_pivot", "short_segment", "past_pivot",
                             "through_pivot", "in_line",   "at_an_end",     "from_afar"};
  return names[static_cast<std::size_t>(situation)];
}

SegmentArrays make_segments(Situation situation, Pose pose, std::size_t n, std::uint32_t seed) {
  Random random(seed);
  SegmentArrays result;
  const auto rounded = [](const Vector<double>& v) {
    return Vec3{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
  };
  for (std::size_t i = 0; i < n; ++i) {
    const FlatSegment flat = draw(situation, random);
    Vector<double> d{1, 0, 0}, aside{0, 1, 0}, origin{0, 0, 0};
    if (pose == Pose::general) {
      const double z = random.uniform(-1, 1), phi = random.uniform(0, 2 * M_PI), r = std::sqrt(1 - z * z);
      d = {r * std::cos(phi), r * std::sin(phi), z};
      aside = normalize(cross(d, Vector<double>{0.3, -0.8, 0.5}));
      origin = {random.uniform(-30, 30), random.uniform(-30, 30), random.uniform(-30, 30)};
    }
    result.push_back({rounded(origin), rounded(d), static_cast<float>(flat.t_min), static_cast<float>(flat.t_max)},
                     rounded(origin + flat.foot * d + flat.distance * aside));
  }
  return result;
}

SegmentArrays mixed_segments(Pose pose, std::size_t n_of_each) {
  SegmentArrays result;
  for (const Situation situation : all_situations) {
    const SegmentArrays some = make_segments(situation, pose, n_of_each);
    for (std::size_t i = 0; i < some.size(); ++i) result.push_back(some.segment(i), some.pivot[i]);
  }
  return result;
}

DistanceArrays sample(const SegmentArrays& segments, std::span<const float> u, std::optional<std::size_t> grain) {
  DistanceArrays out{std::vector<float>(u.size(), -1), std::vector<float>(u.size(), -1)};
  if (grain) {
    parallel::equiangular::sample(segments.view(), segments.pivot.view(), u, out.t, out.pdf, *grain);
  } else {
    equiangular::sample(segments.view(), segments.pivot.view(), u, out.t, out.pdf);
  }
  return out;
}

std::vector<float> pdf(const SegmentArrays& segments, std::span<const float> t, std::optional<std::size_t> grain) {
  std::vector<float> out(t.size(), -1);
  if (grain) {
    parallel::equiangular::pdf(segments.view(), segments.pivot.view(), t, out, *grain);
  } else {
    equiangular::pdf(segments.view(), segments.pivot.view(), t, out);
  }
  return out;
}

}  // namespace hatbox::test
