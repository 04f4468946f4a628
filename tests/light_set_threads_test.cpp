// A Workspace has a block for every thread that TBB sends to work in the caller's arena.
#include "support/bits.h"
#include "support/light_sets.h"
#include "support/workloads.h"

#include <hatbox/hatbox.h>

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

namespace hatbox::test {
namespace {

/// Points with lights of all kinds, and what a sequential call makes of them.
struct SolidAngles {
  static constexpr std::size_t n = 5000, grain = 32;

  MixedLights lights{Pose::canonical, 4};
  LightSet set = lights.set({});
  PointArrays points = make_points(Workload::w1, Pose::canonical, n);
  std::vector<std::uint32_t> chosen = random_choices(n, lights.size());
  std::vector<float> expected = std::vector<float>(n);

  SolidAngles() {
    Workspace workspace;
    solid_angle(set, chosen, points.view(), expected, workspace);
  }

  bool right_in_parallel(Workspace& workspace) const {
    std::vector<float> got(n);
    parallel::solid_angle(set, chosen, points.view(), got, workspace, grain);
    return first_difference(got, expected) == n;
  }
};

TEST(LightSetThreads, EveryThreadHasAWorkspaceOfItsOwn) {
  const SolidAngles work;
  std::atomic<int> wrong = 0;
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] {
      Workspace workspace;
      for (int again = 0; again < 20; ++again) wrong += !work.right_in_parallel(workspace);
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, 0);
}

TEST(LightSetThreads, ArenasOfAllSizesWithOneWorkspace) {
  const SolidAngles work;
  Workspace workspace;
  for (const int threads : {1, 2, 5, 1}) {
    tbb::task_arena arena(threads);
    arena.execute([&] { EXPECT_TRUE(work.right_in_parallel(workspace)) << threads; });
  }
}

/// A task that someone enqueues brings a worker into an arena that was made for one thread, and when the task is done,
/// the worker helps with whatever there is. When that happens is up to TBB, hence the many tries.
TEST(LightSetThreads, AWorkerJoinsAnArenaForOne) {
  using namespace std::chrono_literals;
  const SolidAngles work;
  tbb::task_arena arena(1);
  arena.initialize();
  std::atomic<bool> done = false;
  std::atomic<int> enqueued = 0;
  std::thread other([&] {
    for (; !done; std::this_thread::sleep_for(200us)) {
      if (enqueued > 3) continue;
      ++enqueued;
      arena.enqueue([&] {
        std::this_thread::sleep_for(50us);
        --enqueued;
      });
    }
  });
  int wrong = 0;
  arena.execute([&] {
    const auto end = std::chrono::steady_clock::now() + 1s;
    while (std::chrono::steady_clock::now() < end) {
      Workspace workspace;
      wrong += !work.right_in_parallel(workspace);
    }
  });
  done = true;
  other.join();
  while (enqueued > 0) std::this_thread::yield();
  EXPECT_EQ(wrong, 0);
}

}  // namespace
}  // namespace hatbox::test
