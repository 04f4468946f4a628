// The shading points and variates that the tests run on, and arrays to hold them and what comes out.
#pragma once

#include "reference/vector.h"

#include <hatbox/arrays.h>
#include <hatbox/lights.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hatbox::test {

enum class Pose { canonical, general };
const char* name(Pose pose);

/// The unit disk at the origin facing +z, or normal (0.36, 0.48, 0.8), centre (100, −50, 20), radius 3.7.
Disk disk_in(Pose pose);

/// A direction given at the canonical disk, turned as the disk is turned into the pose.
reference::Vector<double> turned(Pose pose, const reference::Vector<double>& local);

/// Where a point given around the unit disk comes to lie when the disk is moved into the pose.
Vec3 moved(Pose pose, const reference::Vector<double>& local);

struct PointArrays {
  std::vector<float> x, y, z;

  std::size_t size() const { return x.size(); }
  Vec3 operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
  void push_back(const Vec3& p);
  Points view() const { return {x, y, z}; }
  Points view(std::size_t offset, std::size_t count) const;
};

/// w1: x, y ±3, z 0.05–3.05. w2: x, y ±1.5, z log-uniform 1e-5–1e-1. w3: distance log-uniform 10–1e5, any direction.
enum class Workload { w1, w2, w3 };
inline constexpr std::array all_workloads{Workload::w1, Workload::w2, Workload::w3};
const char* name(Workload workload);

PointArrays make_points(Workload workload, Pose pose, std::size_t n, std::uint32_t seed = 1);

/// `n` times the same point.
PointArrays repeat(const Vec3& point, std::size_t n);

struct VariateArrays {
  std::vector<float> u, v;

  std::size_t size() const { return u.size(); }
  Variates view() const { return {u, v}; }
  Variates view(std::size_t offset, std::size_t count) const;
};

VariateArrays make_variates(std::size_t n, std::uint32_t seed = 2);

/// The same grid of side × side jittered cells for each of n points: side² variates a point, in the order of k·n
/// arrays.
VariateArrays make_stratified(std::size_t n, std::size_t side, std::uint32_t seed = 3);

/// Samples a point, and numbers of points around the widths of packets, that the tests run with.
inline constexpr std::size_t sample_counts[] = {1, 3};
inline constexpr std::size_t odd_sizes[] = {0, 1, 7, 8, 9, 15, 16, 17};

/// Every output of `sample`, filled with a value that no call writes.
struct SampleArrays {
  enum Column { x, y, z, distance, pdf, s, t, cosine, column_count };
  static constexpr float untouched = -12345.5f;

  explicit SampleArrays(std::size_t n);

  std::size_t size() const { return columns[0].size(); }
  Samples view() { return view(0, size()); }
  Samples view(std::size_t offset, std::size_t count);
  float at(Column column, std::size_t i) const { return columns[column][i]; }
  bool valid(std::size_t i) const { return at(pdf, i) > 0; }
  reference::Vector<double> direction(std::size_t i) const;
  Directions directions() const { return {columns[x], columns[y], columns[z]}; }
  Places places() const { return {columns[s], columns[t]}; }

  std::array<std::vector<float>, column_count> columns;
};

const char* name(SampleArrays::Column column);

}  // namespace hatbox::test
