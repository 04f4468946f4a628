// The checks of a call's arguments. They throw std::invalid_argument that names the argument and its value, before
// anything is written.
#pragma once

#include <hatbox/arrays.h>
#include <hatbox/lights.h>

#include <cstddef>
#include <span>
#include <string>

namespace hatbox {

bool is_finite(const Vec3& v);

/// For messages: as many digits as tell a number from all others; "(x, y, z)".
std::string to_string(float x);
std::string to_string(const Vec3& v);

/// How many shading points a call has and how many numbers (samples or queries) for each of them.
struct BatchSize {
  std::size_t points;
  std::size_t per_point;

  std::size_t total() const { return points * per_point; }
};

/// The common length of the three spans.
std::size_t checked_size(const Points& points);

BatchSize checked_size(const Points& points, const Variates& variates);
BatchSize checked_size(const Points& points, const Directions& directions);
BatchSize checked_size(const Points& points, const Places& places);

void check_size(const char* name, std::span<const float> array, std::size_t expected);

/// As above, but an empty span will do too.
void check_size_or_empty(const char* name, std::span<const float> array, std::size_t expected);

/// How many each of n `of_what` has of `count` numbers, the same for all of them.
std::size_t checked_multiple(const char* name, std::size_t count, std::size_t n, const char* of_what);

void check_outputs(const Samples& out, std::size_t expected);

}  // namespace hatbox
