// The arrays of one benchmark case, filled with the workload's points and with random variates.
#pragma once

#include <hatbox/arrays.h>
#include <hatbox/isa.h>

#include <cstddef>
#include <random>
#include <vector>

namespace hatbox::bench {

/// The same numbers on every platform.
class Random {
 public:
  float operator()(float low, float high);

 private:
  std::mt19937 engine_{1};
};

/// n shading points around the unit disk: x, y uniform ±3, z uniform 0.05–3.05 (W1), and k samples for each of them.
class Arrays {
 public:
  Arrays(std::size_t points, std::size_t samples_per_point);

  /// The points on a sphere about the disk instead, uniform in all directions.
  Arrays(std::size_t points, std::size_t samples_per_point, double distance);

  Points points() const { return {x_, y_, z_}; }
  Variates variates() const { return {u_, v_}; }
  Samples samples() { return {out_[0], out_[1], out_[2], out_[3], out_[4]}; }
  std::size_t point_count() const { return x_.size(); }
  std::size_t sample_count() const { return u_.size(); }

 private:
  void add_samples(std::size_t samples);

  Random random_;
  std::vector<float> x_, y_, z_, u_, v_, out_[5];
};

/// Made once for each size and shared by all cases, so that all of them see the same memory.
Arrays& shared_arrays(std::size_t points, std::size_t samples_per_point);

/// Points a call of the cases whose arrays no cache holds.
inline constexpr std::size_t points_in_memory = std::size_t{1} << 20;

/// Bound by arithmetic, wherever the arrays are, and with points_in_memory minutes to wait for.
inline bool is_slow(Isa isa) { return isa == Isa::scalar || isa == Isa::sse4_2; }

}  // namespace hatbox::bench
