#include "pictures.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace wavefront {
namespace {

/// `position` in [0, 1] along the colours.
Rgb ramp(float position) {
  static const std::array<Rgb, 7> colours = {
      {{0, 0, 0}, {0, 0, 1}, {0, 0.7f, 1}, {0, 0.6f, 0}, {1, 0.9f, 0}, {1, 0, 0}, {1, 1, 1}}};
  const float place = std::clamp(position, 0.0f, 1.0f) * static_cast<float>(colours.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(place), colours.size() - 2);
  const float rest = place - static_cast<float>(below);
  return colours[below] * (1 - rest) + colours[below + 1] * rest;
}

float mean(const Rgb& colour) { return (colour.x + colour.y + colour.z) / 3; }

}  // namespace

Image false_colour_error(const Image& image, const Image& reference) {
  constexpr float decades = 4;
  Image result(image.width, image.height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const float error = std::abs(mean(image.pixels[i]) - mean(reference.pixels[i]));
    result.pixels[i] = ramp(1 + std::log10(std::max(error, 1e-9f)) / decades);
  }
  return result;
}

Image side_by_side(const std::vector<std::vector<const Image*>>& rows) {
  const Image& tile = *rows.front().front();
  constexpr int gap = 4;
  Image result(static_cast<int>(rows.front().size()) * (tile.width + gap) - gap,
               static_cast<int>(rows.size()) * (tile.height + gap) - gap);
  std::fill(result.pixels.begin(), result.pixels.end(), Rgb(1.0f));
  for (std::size_t row = 0; row < rows.size(); ++row)
    for (std::size_t column = 0; column < rows[row].size(); ++column)
      for (int y = 0; y < tile.height; ++y) {
        const int left = static_cast<int>(column) * (tile.width + gap);
        const int line = static_cast<int>(row) * (tile.height + gap) + y;
        const auto source = rows[row][column]->pixels.begin() + static_cast<std::ptrdiff_t>(tile.index(0, y));
        std::copy_n(source, tile.width, result.pixels.begin() + static_cast<std::ptrdiff_t>(result.index(left, line)));
      }
  return result;
}

}  // namespace wavefront
