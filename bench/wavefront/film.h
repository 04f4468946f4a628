// Pictures of linear RGB radiance, and files of them.
#pragma once

#include "scene.h"

#include <filesystem>
#include <vector>

namespace wavefront {

struct Image {
  /// Black.
  Image(int width_, int height_)
      : width(width_),
        height(height_),
        pixels(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), Rgb(0.0f)) {}

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }

  int width, height;
  std::vector<Rgb> pixels;  // row by row from the upper left
};

/// 32-bit float. Throws std::runtime_error.
void write_exr(const Image& image, const std::filesystem::path& path);

/// 8-bit sRGB, clipped at one. Throws std::runtime_error.
void write_png(const Image& image, const std::filesystem::path& path);

/// The mean over pixels and channels of the squared difference. Both must have the same size.
double mean_squared_error(const Image& a, const Image& b);

}  // namespace wavefront
