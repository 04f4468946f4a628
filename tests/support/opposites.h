// A check that the round-trip tests of all lights share.
#pragma once

#include "support/workloads.h"

#include <hatbox/hatbox.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace hatbox::test {

/// Away from the light there is nothing to hit. Turns the samples' directions round.
template <class Light, class Map>
void expect_opposites_miss(const Light& light, const Map& map, const Points& points, SampleArrays& samples) {
  for (const auto c : {SampleArrays::x, SampleArrays::y, SampleArrays::z}) {
    for (float& value : samples.columns[c]) value = -value;
  }
  std::vector<float> density(samples.size()), u(samples.size()), v(samples.size());
  pdf(light, map, points, samples.directions(), density);
  invert(light, map, points, samples.directions(), u, v);
  EXPECT_TRUE(std::ranges::all_of(density, [](float x) { return x == 0; }));
  EXPECT_TRUE(std::ranges::all_of(u, [](float x) { return x == -1; }));
  EXPECT_TRUE(std::ranges::all_of(v, [](float x) { return x == -1; }));
}

}  // namespace hatbox::test
