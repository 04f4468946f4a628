// hatbox_fuzz: any bytes as calls of the public API (libFuzzer). What must hold of every one: nothing is thrown but
// std::invalid_argument, exactly where the headers say so, and nothing is written then; otherwise every lane keeps the
// rules (lane_faults.h), and what ought to be sampled is (samplable.h). `./run fuzz` builds and runs it.
#include "fuzz/targets.h"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hatbox::fuzz;
  using Target = void (*)(Input&, const Manner&);
  constexpr Target targets[] = {exercise_disk,  exercise_ellipse, exercise_rectangle, exercise_triangle,
                                exercise_table, exercise_set,     exercise_set,       exercise_equiangular,
                                exercise_clip,  exercise_carlson, exercise_isa};
  Input input(data, size);
  const Target target = targets[input.below(std::size(targets))];
  const Manner manner(input);
  // The judges' arithmetic too: where denormals are 0, a light that is told in some is another.
  const hatbox::test::FlushedDenormals flushed(manner.flushing);
  target(input, manner);
  return 0;
}
