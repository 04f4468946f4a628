// What the fuzzer calls: all of the public API, in parts.
#pragma once

#include "fuzz/manner.h"
#include "support/sampler.h"

#include <functional>
#include <vector>

namespace hatbox::fuzz {

/// What is refused whatever the arrays: any call for a light that is none, all but its solid angle for a map that is
/// none.
struct Refused {
  bool light, map;
};

/// All calls of a sampler. `samplable(i, point)`: whether point i's lanes ought to be sampled, if its variates are
/// good.
void exercise(Input& input, const Manner& manner, const test::Sampler& sampler, std::size_t points, Refused refused,
              const std::function<Vec3(Input&)>& make_point, const std::function<bool(std::size_t, Vec3)>& samplable);

void exercise_disk(Input& input, const Manner& manner);
void exercise_ellipse(Input& input, const Manner& manner);
void exercise_rectangle(Input& input, const Manner& manner);
void exercise_triangle(Input& input, const Manner& manner);
void exercise_table(Input& input, const Manner& manner);
void exercise_set(Input& input, const Manner& manner);
void exercise_equiangular(Input& input, const Manner& manner);
void exercise_clip(Input& input, const Manner& manner);
void exercise_carlson(Input& input, const Manner& manner);
void exercise_isa(Input& input, const Manner& manner);

}  // namespace hatbox::fuzz
