#include "support/workloads.h"

#include "support/random.h"

#include <cmath>
#include <numbers>

namespace hatbox::test {
namespace {

using reference::Vector;

Vector<double> draw(Workload workload, Random& random) {
  switch (workload) {
    case Workload::w1: {
      const double x = random.uniform(-3, 3), y = random.uniform(-3, 3);
      return {x, y, random.uniform(0.05, 3.05)};
    }
    case Workload::w2: {
      const double x = random.uniform(-1.5, 1.5), y = random.uniform(-1.5, 1.5);
      return {x, y, random.log_uniform(1e-5, 1e-1)};
    }
    default: {
      const double distance = random.log_uniform(10, 1e5), z = random.uniform(-1, 1);
      const double phi = random.uniform(0, 2 * std::numbers::pi), ring = std::sqrt(1 - z * z);
      return {distance * ring * std::cos(phi), distance * ring * std::sin(phi), distance * z};
    }
  }
}

}  // namespace

double Random::log_uniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }

const char* name(Pose pose) { return pose == Pose::canonical ? "canonical" : "general"; }

const char* name(Workload workload) {
  constexpr std::array names{"W1", "W2", "W3"};
  return names[static_cast<std::size_t>(workload)];
}

const char* name(SampleArrays::Column column) {
  constexpr std::array names{"x", "y", "z", "distance", "pdf", "s", "t", "cosine"};
  return names[column];
}

Disk disk_in(Pose pose) {
  if (pose == Pose::canonical) return {{0, 0, 0}, {0, 0, 1}, 1};
  return {{100, -50, 20}, {0.36f, 0.48f, 0.8f}, 3.7f};
}

Vector<double> turned(Pose pose, const Vector<double>& local) {
  if (pose == Pose::canonical) return local;
  const auto n = normalize(reference::convert<double>(disk_in(pose).normal));
  const auto u = normalize(cross(n, Vector<double>{0, 1, 0}));
  return local.x * u + local.y * cross(n, u) + local.z * n;
}

Vec3 moved(Pose pose, const Vector<double>& local) {
  const Disk light = disk_in(pose);
  const double radius = light.radius;
  const Vector<double> p = reference::convert<double>(light.center) + radius * turned(pose, local);
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

void PointArrays::push_back(const Vec3& p) {
  x.push_back(p.x);
  y.push_back(p.y);
  z.push_back(p.z);
}

Points PointArrays::view(std::size_t offset, std::size_t count) const {
  return {std::span(x).subspan(offset, count), std::span(y).subspan(offset, count),
          std::span(z).subspan(offset, count)};
}

PointArrays make_points(Workload workload, Pose pose, std::size_t n, std::uint32_t seed) {
  Random random(seed);
  PointArrays points;
  for (std::size_t i = 0; i < n; ++i) points.push_back(moved(pose, draw(workload, random)));
  return points;
}

PointArrays repeat(const Vec3& point, std::size_t n) {
  return {std::vector<float>(n, point.x), std::vector<float>(n, point.y), std::vector<float>(n, point.z)};
}

Variates VariateArrays::view(std::size_t offset, std::size_t count) const {
  return {std::span(u).subspan(offset, count), std::span(v).subspan(offset, count)};
}

VariateArrays make_variates(std::size_t n, std::uint32_t seed) {
  Random random(seed);
  VariateArrays variates;
  for (std::size_t i = 0; i < n; ++i) {
    variates.u.push_back(random.unit_float());
    variates.v.push_back(random.unit_float());
  }
  return variates;
}

VariateArrays make_stratified(std::size_t n, std::size_t side, std::uint32_t seed) {
  Random random(seed);
  VariateArrays variates;
  const auto cell = 1 / static_cast<double>(side);
  for (std::size_t j = 0; j < side * side; ++j) {
    const std::size_t column = j % side, row = j / side;
    for (std::size_t i = 0; i < n; ++i) {
      variates.u.push_back(static_cast<float>((static_cast<double>(column) + random.unit()) * cell));
      variates.v.push_back(static_cast<float>((static_cast<double>(row) + random.unit()) * cell));
    }
  }
  return variates;
}

SampleArrays::SampleArrays(std::size_t n) {
  for (auto& column : columns) column.assign(n, untouched);
}

Samples SampleArrays::view(std::size_t offset, std::size_t count) {
  const auto part = [&](Column column) { return std::span(columns[column]).subspan(offset, count); };
  return {part(x), part(y), part(z), part(distance), part(pdf), part(s), part(t), part(cosine)};
}

reference::Vector<double> SampleArrays::direction(std::size_t i) const { return {at(x, i), at(y, i), at(z, i)}; }

}  // namespace hatbox::test
