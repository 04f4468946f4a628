#include "arrays.h"

#include <random>

namespace hatbox::bench {
namespace {

class Random {
 public:
  float operator()(float low, float high) { return low + (high - low) * static_cast<float>(engine_() >> 8) * 0x1p-24f; }

 private:
  std::mt19937 engine_{1};
};

}  // namespace

Arrays::Arrays(std::size_t points, std::size_t samples_per_point) {
  Random random;
  const std::size_t samples = points * samples_per_point;
  for (std::size_t i = 0; i < points; ++i) {
    x_.push_back(random(-3, 3));
    y_.push_back(random(-3, 3));
    z_.push_back(random(0.05f, 3.05f));
  }
  u_.reserve(samples);
  v_.reserve(samples);
  for (std::size_t i = 0; i < samples; ++i) {
    u_.push_back(random(0, 1));
    v_.push_back(random(0, 1));
  }
  for (std::vector<float>& out : out_) out.resize(samples);
}

}  // namespace hatbox::bench
