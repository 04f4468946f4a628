// The mean of a picture whose pixels are independent estimates of one number, and how far it may err; a regular grid.
#pragma once

#include "scene_text.h"
#include "wavefront.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wavefront {

/// The middle of one of steps² cells of the unit square.
inline Sample2 cell_middle(int cell, int steps) {
  const int column = cell % steps, row = cell / steps;
  const auto size = static_cast<float>(steps);
  return {(static_cast<float>(column) + 0.5f) / size, (static_cast<float>(row) + 0.5f) / size};
}

struct PictureMean {
  double mean, error;  // one standard deviation of the mean
};

inline PictureMean mean_of(const Image& image, int channel = 0) {
  double sum = 0, sum_of_squares = 0;
  for (const Rgb& pixel : image.pixels) {
    const auto value = static_cast<double>(pixel[channel]);
    EXPECT_TRUE(std::isfinite(value));
    sum += value;
    sum_of_squares += value * value;
  }
  const auto n = static_cast<double>(image.pixels.size());
  return {sum / n, std::sqrt(std::max(sum_of_squares / n - sum * sum / (n * n), 0.0) / (n - 1))};
}

inline PictureMean mean_of(const Scene& scene, const RenderSettings& settings) {
  return mean_of(render(scene, RayTracer(scene), settings, "").image);
}

/// Within five standard deviations, and the rounding of a float; and the comparison must be able to tell something.
inline void expect_agreement(const PictureMean& a, const PictureMean& b, double largest_error) {
  const double error = std::hypot(a.error, b.error);
  EXPECT_LT(error, largest_error * b.mean);
  EXPECT_NEAR(a.mean, b.mean, 5 * error + 2e-5 * b.mean);
}

}  // namespace wavefront
