// The arrays between the stages of the renderer.
#pragma once

#include "scene.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace wavefront {

/// Camera paths that hit a surface which light can reach, in the order of the paths.
struct HitQueue {
  std::vector<float> x, y, z;  // shading point
  std::vector<float> normal_x, normal_y, normal_z;
  std::vector<float> origin_x, origin_y, origin_z;  // of shadow rays
  std::vector<std::uint32_t> path;
  std::vector<const Shape*> shape;

  std::size_t size() const { return path.size(); }

  void resize(std::size_t n) {
    for_each_array([n](auto& array) { array.resize(n); });
  }

  /// Moves `count` hits down from `from` to `to`.
  void move(std::size_t from, std::size_t to, std::size_t count) {
    for_each_array([=](auto& array) { std::copy_n(array.data() + from, count, array.data() + to); });
  }

 private:
  template <class Function>
  void for_each_array(Function function) {
    for (auto* array : {&x, &y, &z, &normal_x, &normal_y, &normal_z, &origin_x, &origin_y, &origin_z}) function(*array);
    function(path);
    function(shape);
  }
};

/// k light samples a hit: sample j of hit i lies at [j·n + i], as hatbox has it.
struct LightQueue {
  std::vector<float> u, v;                            // in
  std::vector<float> x, y, z, distance, pdf, cosine;  // out

  void resize(std::size_t n) {
    for (auto* array : {&u, &v, &x, &y, &z, &distance, &pdf, &cosine}) array->resize(n);
  }
};

}  // namespace wavefront
