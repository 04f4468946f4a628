// What calls in parallel have of the thread that makes them.
#include "schedule.h"
#include "support/bits.h"
#include "support/denormals.h"
#include "support/segments.h"

#include <hatbox/disk.h>
#include <hatbox/disk_table.h>

#include <gtest/gtest.h>
#include <tbb/task_group.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

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

/// A task group that is cancelled stops the parallel loops of its tasks, but for those that are isolated from it.
TEST(ParallelCalls, AreFinishedInACancelledTask) {
  constexpr std::size_t n = 100000;
  const Disk disk = {{0, 0, 0}, {0, 0, 1}, 1};
  const std::vector<float> x(n, 0.0f), z(n, 1.0f), half(n, 0.5f);
  std::vector<float> pdf(n, -1.0f), of_table(n, -1.0f);
  tbb::task_group group;
  group.run_and_wait([&] {
    group.cancel();
    const Points points = {x, x, z};
    parallel::sample(disk, DiskMap::ld_radial, points, {half, half}, {{}, {}, {}, {}, pdf});
    const DiskTable table(DiskMap::ld_radial, 64);
    parallel::sample(disk, table, points, {half, half}, {{}, {}, {}, {}, of_table});
  });
  for (std::size_t i = 0; i < n; ++i) {
    ASSERT_GT(pdf[i], 0);
    ASSERT_NEAR(of_table[i], pdf[i], 1e-5f);
  }
}

/// The grain is the least number of points a block.
TEST(ParallelCalls, BlocksAreNoSmallerThanTheGrain) {
  for (const std::size_t grain : {std::size_t{1}, std::size_t{33}, std::size_t{1000}, SIZE_MAX / 2}) {
    EXPECT_GE(block_size(grain, 1), grain);
    EXPECT_EQ(block_size(grain, 1) % widest_packet, 0u);
  }
  EXPECT_EQ(block_size(SIZE_MAX, 1), SIZE_MAX / widest_packet * widest_packet);
}

/// The results after the points that are worked on first begin a cache line; few or none are not worth it.
TEST(Schedule, LongJobsWriteWholeCacheLines) {
  alignas(64) float numbers[32] = {};
  for (std::size_t past = 0; past < 16; ++past) {
    const std::size_t head = points_before_line(&numbers[past], 4096, 16);
    EXPECT_LT(head, 16u);
    EXPECT_EQ((past + head) % 16, 0u);
    EXPECT_EQ(points_before_line(&numbers[past], 16, 4096), 0u);
    EXPECT_EQ(points_before_line(&numbers[past], 4096, 1), 0u);
    EXPECT_EQ(points_before_line(&numbers[past], 4097, 16), 0u);
    EXPECT_EQ(points_before_line(&numbers[past], 40001, 1), head);
  }
  EXPECT_EQ(points_before_line(nullptr, 4096, 16), 0u);
}

TEST(Schedule, WhereResultsLieChangesNoBits) {
  constexpr std::size_t n = 2112, k = 16, room = 16;
  const Disk disk = {{0, 0, 0}, {0, 0, 1}, 1};
  std::vector<float> x, variate;
  for (std::size_t i = 0; i < n; ++i) x.push_back(0.001f * static_cast<float>(i));
  for (std::size_t i = 0; i < n * k; ++i) variate.push_back(static_cast<float>(i * 37 % 4096) * 0x1p-12f);
  const std::vector<float> z(n, 0.5f);
  const Points points = {x, x, z};
  const auto called_at = [&](std::size_t past, bool in_parallel) {
    std::vector<float> numbers(4 * n * k + room);
    const auto row = [&](std::size_t i) { return std::span(numbers).subspan(past + i * n * k, n * k); };
    const Directions directions = {variate, variate, variate};
    if (in_parallel) {
      parallel::sample(disk, DiskMap::ld_radial, points, {variate, variate}, {{}, {}, {}, row(0), row(1)}, 100);
      parallel::invert(disk, DiskMap::ld_radial, points, directions, row(2), row(3));
    } else {
      sample(disk, DiskMap::ld_radial, points, {variate, variate}, {{}, {}, {}, row(0), row(1)});
      invert(disk, DiskMap::ld_radial, points, directions, row(2), row(3));
    }
    numbers.erase(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(past));
    return numbers;
  };
  const std::vector<float> expected = called_at(0, false);
  for (const bool in_parallel : {false, true}) {
    for (const std::size_t past : {0u, 1u, 3u, 15u}) {
      const std::vector<float> found = called_at(past, in_parallel);
      for (std::size_t i = 0; i < 4 * n * k; ++i) ASSERT_TRUE(same_bits(found[i], expected[i])) << i << " at " << past;
    }
  }
}

TEST(Schedule, EveryPointIsWorkedOnOnce) {
  for (const bool is_parallel : {false, true}) {
    for (const std::size_t head : {0u, 1u, 15u}) {
      for (const std::size_t points : {1024u, 1039u, 5000u}) {
        std::vector<int> visits(points, 0);
        run_blocks({.parallel = is_parallel, .grain = 100}, points, 1, head, [&](std::size_t begin, std::size_t end) {
          EXPECT_TRUE(end == head || begin >= head);
          for (std::size_t i = begin; i < end; ++i) ++visits[i];  // no two threads have the same ones, if all is well
        });
        EXPECT_EQ(visits, std::vector<int>(points, 1)) << head << " of " << points;
      }
    }
  }
}

}  // namespace
}  // namespace hatbox::test
