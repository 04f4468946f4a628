// What calls in parallel have of the thread that makes them.
#include "support/bits.h"
#include "support/denormals.h"
#include "support/segments.h"

#include <gtest/gtest.h>

namespace hatbox::test {
namespace {

/// Whether TBB's own threads flush denormals is otherwise what the thread did that made them.
TEST(ParallelCalls, FlushDenormalsWhereTheirCallerDoes) {
  constexpr std::size_t n = 20000, grain = 32;
  SegmentArrays segments;
  for (std::size_t i = 0; i < n; ++i) segments.push_back({{0, 0, 0}, {1, 0, 0}, 0x1p-138f, 0x1p-42f}, {1, 1, 0});
  const std::vector<float> u(n, 0.0f);  // of which t_min is made
  for (int again = 0; again < 10; ++again) {
    for (const bool flush : {true, false}) {
      const FlushedDenormals flushed(flush);
      const DistanceArrays alone = sample(segments, u), in_parallel = sample(segments, u, grain);
      ASSERT_EQ(first_difference(in_parallel.t, alone.t), n) << (flush ? "flushed" : "kept");
      ASSERT_GT(alone.pdf[0], 0);
#if defined(__x86_64__)
      ASSERT_TRUE(same_bits(alone.t[0], flush ? 0 : 0x1p-138f));
#endif
    }
  }
}

}  // namespace
}  // namespace hatbox::test
