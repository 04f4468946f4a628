#include "arrays.h"

#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <utility>

namespace hatbox::bench {

float Random::operator()(float low, float high) {
  return low + (high - low) * static_cast<float>(engine_() >> 8) * 0x1p-24f;
}

Arrays::Arrays(std::size_t points, std::size_t samples_per_point) {
  for (std::size_t i = 0; i < points; ++i) {
    x_.push_back(random_(-3, 3));
    y_.push_back(random_(-3, 3));
    z_.push_back(random_(0.05f, 3.05f));
  }
  add_samples(points * samples_per_point);
}

Arrays::Arrays(std::size_t points, std::size_t samples_per_point, double distance) {
  for (std::size_t i = 0; i < points; ++i) {
    const double z = random_(-1, 1), phi = random_(0, 2 * std::numbers::pi_v<float>), ring = std::sqrt(1 - z * z);
    x_.push_back(static_cast<float>(distance * ring * std::cos(phi)));
    y_.push_back(static_cast<float>(distance * ring * std::sin(phi)));
    z_.push_back(static_cast<float>(distance * z));
  }
  add_samples(points * samples_per_point);
}

void Arrays::add_samples(std::size_t samples) {
  u_.reserve(samples);
  v_.reserve(samples);
  for (std::size_t i = 0; i < samples; ++i) {
    u_.push_back(random_(0, 1));
    v_.push_back(random_(0, 1));
  }
  for (std::vector<float>& out : out_) out.resize(samples);
}

Arrays& shared_arrays(std::size_t points, std::size_t samples_per_point) {
  static std::map<std::pair<std::size_t, std::size_t>, std::unique_ptr<Arrays>> all;
  std::unique_ptr<Arrays>& one = all[{points, samples_per_point}];
  if (!one) one = std::make_unique<Arrays>(points, samples_per_point);
  return *one;
}

}  // namespace hatbox::bench
