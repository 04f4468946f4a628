// The arrays between the stages of the renderer.
#pragma once

#include "scattering.h"

#include <hatbox/equiangular.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace wavefront {

struct Range {
  std::size_t first, count;
};

/// An array of structures, column by column, that blocks of camera paths fill in parallel: each its own part, which is
/// as large as it may need; then the parts move together. Most queues are nearly full, so there is little to move.
template <class Columns>
class Queue : public Columns {
 public:
  std::vector<Range> blocks;  // what each block has put in

  std::size_t size() const { return size_; }

  void open(std::size_t block_count, std::size_t block_capacity) {
    resize(block_count * block_capacity);
    blocks.resize(block_count);
    for (std::size_t block = 0; block < block_count; ++block) blocks[block] = {block * block_capacity, 0};
  }

  /// The slot for one more entry of a block.
  std::size_t add(std::size_t block) { return blocks[block].first + blocks[block].count++; }

  void close() {
    std::size_t used = 0;
    for (Range& block : blocks) {
      if (block.first != used)
        this->for_each_column(
            [&](auto& column) { std::copy_n(column.data() + block.first, block.count, column.data() + used); });
      block.first = used;
      used += block.count;
    }
    resize(used);
  }

 private:
  void resize(std::size_t n) {
    this->for_each_column([n](auto& column) { column.resize(n); });
    size_ = n;
  }

  std::size_t size_ = 0;
};

/// Three columns that are a vector.
struct VectorColumns {
  std::vector<float> x, y, z;

  V3f operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
  void set(std::size_t i, const V3f& v) {
    x[i] = v.x;
    y[i] = v.y;
    z[i] = v.z;
  }
  void resize(std::size_t n) {
    for (auto* column : {&x, &y, &z}) column->resize(n);
  }
  hatbox::Points points() const { return {x, y, z}; }
  hatbox::Directions directions() const { return {x, y, z}; }

  template <class Function>
  void for_each_column(Function function) {
    for (auto* column : {&x, &y, &z}) function(*column);
  }
};

/// The parts of camera rays that lie in the medium.
struct RayColumns {
  VectorColumns origin, direction;
  std::vector<float> begin, end;
  std::vector<std::uint32_t> path;

  hatbox::Segments segments() const {
    return {origin.x, origin.y, origin.z, direction.x, direction.y, direction.z, begin, end};
  }

  template <class Function>
  void for_each_column(Function function) {
    origin.for_each_column(function);
    direction.for_each_column(function);
    for (auto* column : {&begin, &end}) function(*column);
    function(path);
  }
};
using RayQueue = Queue<RayColumns>;

constexpr auto any_light = ~std::uint32_t{0};

/// Where light is gathered: points on surfaces, or in the medium. In the order of the camera paths.
struct VertexColumns {
  Scattering scattering;         // the same for all
  VectorColumns position, axis;  // the axis of scattering
  VectorColumns ray_origin;      // clear of the surface
  std::vector<Rgb> throughput;   // from here to the camera, over the density with which the place was chosen
  std::vector<std::uint32_t> path;
  std::vector<std::uint32_t> sequence;  // number of its first sample in its pixel's sequence
  std::vector<std::uint32_t> light;     // the only one it gathers light from, or any_light

  template <class Function>
  void for_each_column(Function function) {
    position.for_each_column(function);
    axis.for_each_column(function);
    ray_origin.for_each_column(function);
    function(throughput);
    for (auto* column : {&path, &sequence, &light}) function(*column);
  }
};
using VertexQueue = Queue<VertexColumns>;

/// k samples of lights a vertex: sample j of vertex i lies at [j·n + i], as hatbox has it.
struct ConnectionQueue {
  std::vector<float> u, v;
  std::vector<std::uint32_t> light;
  std::vector<float> probability;  // of the light
  std::vector<double> total;       // of the weights of all lights, n numbers
  VectorColumns direction;
  std::vector<float> distance, pdf, cosine;

  std::size_t size() const { return light.size(); }

  void resize(std::size_t n, std::size_t k) {
    direction.resize(k * n);
    for (auto* column : {&u, &v, &probability, &distance, &pdf, &cosine}) column->resize(k * n);
    light.resize(k * n);
    total.resize(n);
  }
};

}  // namespace wavefront
