#include "fuzz/input.h"

#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

namespace hatbox::fuzz {
namespace {

std::uint32_t hash(const std::uint8_t* data, std::size_t size) {
  std::uint32_t result = 2166136261u;  // FNV-1a
  for (std::size_t i = 0; i < size; ++i) result = (result ^ data[i]) * 16777619u;
  return result;
}

constexpr float odd[] = {0.0f,
                         -0.0f,
                         1.0f,
                         -1.0f,
                         0.5f,
                         0x1.fffffep-1f,
                         0x1.000002p0f,
                         1e-45f,
                         -1e-45f,
                         1e-39f,
                         std::numeric_limits<float>::min(),
                         std::numeric_limits<float>::max(),
                         -std::numeric_limits<float>::max(),
                         std::numeric_limits<float>::infinity(),
                         -std::numeric_limits<float>::infinity(),
                         std::numeric_limits<float>::quiet_NaN()};

}  // namespace

Input::Input(const std::uint8_t* data, std::size_t size) : data_(data, size), random_(hash(data, size)) {}

std::uint32_t Input::bits() {
  if (data_.remaining_bytes() >= sizeof(std::uint32_t)) return data_.ConsumeIntegral<std::uint32_t>();
  const auto upper = static_cast<std::uint32_t>(random_.unit() * 0x1p16);
  return upper << 16 | static_cast<std::uint32_t>(random_.unit() * 0x1p16);
}

float Input::fresh() {
  const std::uint32_t kind = bits() % 8, more = bits();
  switch (kind) {
    case 0: return odd[more % std::size(odd)];
    case 1: return std::bit_cast<float>(more);
    case 2: return static_cast<float>(static_cast<int>(more % 33) - 16);
    case 3: return std::ldexp(more & 1 ? -1.0f : 1.0f, static_cast<int>(more / 2 % 300) - 150);
    default: return (static_cast<float>(more >> 8) * 0x1p-23f - 1) * 4;
  }
}

float Input::number() {
  if (!earlier_.empty() && one_in(4)) {
    const float known = earlier_[below(earlier_.size())];
    const auto ulps = static_cast<std::uint32_t>(below(9));  // more often none than not
    return ulps < 5 ? known : std::bit_cast<float>(std::bit_cast<std::uint32_t>(known) + ulps - 6);
  }
  const float result = fresh();
  if (earlier_.size() < 32) earlier_.push_back(result);
  return result;
}

std::vector<float> Input::numbers(std::size_t count) {
  std::vector<float> result;
  for (std::size_t i = 0; i < count; ++i) result.push_back(number());
  return result;
}

float Input::variate() { return one_in(4) ? number() : static_cast<float>(bits() >> 8) * 0x1p-24f; }

std::size_t Input::count() {
  constexpr std::size_t counts[] = {0, 1, 2, 7, 8, 9, 15, 16, 17, 31, 33, 40};
  // Of a set more than a block; with many samples a point a job that writes whole cache lines.
  constexpr std::size_t many = 1104;
  if (one_in(128)) return many;
  return counts[below(std::size(counts))];
}

std::string told(const std::vector<float>& numbers) {
  std::string result;
  for (const float number : numbers) {
    char text[32];
    std::snprintf(text, sizeof text, " %a", static_cast<double>(number));
    result += text;
  }
  return result;
}

void require(bool holds, const std::string& what) {
  if (holds) return;
  std::fprintf(stderr, "hatbox_fuzz: %s\n", what.c_str());
  std::abort();
}

}  // namespace hatbox::fuzz
