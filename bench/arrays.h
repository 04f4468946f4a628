// The arrays of one benchmark case, filled with the workload's points and with random variates.
#pragma once

#include <hatbox/arrays.h>

#include <cstddef>
#include <vector>

namespace hatbox::bench {

/// n shading points around the unit disk: x, y uniform ±3, z uniform 0.05–3.05 (W1), and k samples for each of them.
class Arrays {
 public:
  Arrays(std::size_t points, std::size_t samples_per_point);

  Points points() const { return {x_, y_, z_}; }
  Variates variates() const { return {u_, v_}; }
  Samples samples() { return {out_[0], out_[1], out_[2], out_[3], out_[4]}; }
  std::size_t point_count() const { return x_.size(); }
  std::size_t sample_count() const { return u_.size(); }

 private:
  std::vector<float> x_, y_, z_, u_, v_, out_[5];
};

}  // namespace hatbox::bench
