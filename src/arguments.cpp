#include "arguments.h"

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hatbox {
namespace {

// Messages are made here, apart from what every call asks: calls for a few points take no longer than these questions.
[[noreturn, gnu::cold, gnu::noinline]] void reject(const char* name, std::size_t size, const std::string& expected) {
  throw std::invalid_argument(std::string(name) + ": has " + std::to_string(size) + " elements, expected " + expected);
}

[[noreturn, gnu::cold, gnu::noinline]] void reject(const char* name, std::size_t size, std::size_t expected,
                                                   const char* or_else = "") {
  reject(name, size, std::to_string(expected) + or_else);
}

[[noreturn, gnu::cold, gnu::noinline]] void reject_multiple(const char* name, std::size_t count, std::size_t n,
                                                            const char* of_what) {
  reject(name, count, "a multiple of the " + std::to_string(n) + " " + of_what);
}

BatchSize checked_batch(const Points& points, const char* name, std::size_t count) {
  const std::size_t n = checked_size(points);
  return {n, checked_multiple(name, count, n, "points")};
}

}  // namespace

bool is_finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

std::string to_string(float x) {
  std::array<char, 32> digits = {};
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), x).ptr};
}

std::string to_string(const Vec3& v) {
  return std::string("(") + to_string(v.x) + ", " + to_string(v.y) + ", " + to_string(v.z) + ")";
}

void check_size(const char* name, std::span<const float> array, std::size_t expected) {
  if (array.size() != expected) reject(name, array.size(), expected);
}

void check_size_or_empty(const char* name, std::span<const float> array, std::size_t expected) {
  if (!array.empty() && array.size() != expected) reject(name, array.size(), expected, " or none");
}

std::size_t checked_multiple(const char* name, std::size_t count, std::size_t n, const char* of_what) {
  if (n == 0 ? count != 0 : count % n != 0) reject_multiple(name, count, n, of_what);
  return n == 0 ? 0 : count / n;
}

std::size_t checked_size(const Points& points) {
  check_size("points.y", points.y, points.x.size());
  check_size("points.z", points.z, points.x.size());
  return points.x.size();
}

BatchSize checked_size(const Points& points, const Variates& variates) {
  check_size("variates.v", variates.v, variates.u.size());
  return checked_batch(points, "variates.u", variates.u.size());
}

BatchSize checked_size(const Points& points, const Directions& directions) {
  check_size("directions.y", directions.y, directions.x.size());
  check_size("directions.z", directions.z, directions.x.size());
  return checked_batch(points, "directions.x", directions.x.size());
}

BatchSize checked_size(const Points& points, const Places& places) {
  check_size("places.t", places.t, places.s.size());
  return checked_batch(points, "places.s", places.s.size());
}

void check_outputs(const Samples& out, std::size_t expected) {
  check_size_or_empty("samples.x", out.x, expected);
  check_size_or_empty("samples.y", out.y, expected);
  check_size_or_empty("samples.z", out.z, expected);
  check_size_or_empty("samples.distance", out.distance, expected);
  check_size_or_empty("samples.pdf", out.pdf, expected);
  check_size_or_empty("samples.s", out.s, expected);
  check_size_or_empty("samples.t", out.t, expected);
  check_size_or_empty("samples.cosine", out.cosine, expected);
}

}  // namespace hatbox
