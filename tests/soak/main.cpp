// hatbox_soak: random hostile lanes through every map of every light and through a set of them, and what must hold of
// each, and that those are sampled which ought to be, is looked at (judge.h). Several host threads call at once, some
// inside an arena of their own with one thread, some with denormals flushed to zero, while another thread keeps forcing
// instruction sets.
#include "soak/hostile_scene.h"
#include "soak/judge.h"
#include "support/denormals.h"

#include <CLI/CLI.hpp>

#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <exception>
#include <string>
#include <thread>
#include <vector>

namespace {

using namespace hatbox;
using namespace hatbox::test;

constexpr std::size_t lanes_per_call = 2500;  // no multiple of any packet, and of a set more than a block

/// How a host thread calls the library.
enum class Manner { plain, flushing, in_parallel, in_narrow_arena };
constexpr const char* manner_names[] = {"plain", "denormals flushed", "parallel", "parallel in an arena of one thread"};

void soak_scene(std::uint64_t number, Judge& judge) {
  const auto manner = static_cast<Manner>(number % std::size(manner_names));
  const HostileScene scene(number, lanes_per_call);
  const std::string where = "scene " + std::to_string(number) + ", " + manner_names[static_cast<int>(manner)];
  const Grain grain = manner < Manner::in_parallel ? Grain{} : Grain{64};
  for (std::size_t m = 0; m < scene.samplers.size(); ++m) {
    const Sampler& sampler = scene.samplers[m];
    SampleArrays samples(lanes_per_call);
    std::vector<float> densities(lanes_per_call);
    const auto call = [&] {
      const FlushedDenormals flushed(manner == Manner::flushing);
      sampler.sample(scene.points.view(), scene.variates.view(), samples.view(), grain);
      sampler.pdf_of_direction(scene.points.view(), samples.directions(), densities, grain);
    };
    if (manner == Manner::in_narrow_arena) {
      tbb::task_arena(1).execute(call);
    } else {
      call();
    }
    judge.judge(sampler, scene.points, scene.samplable[m], samples, densities, where);
  }
}

/// Mostly the wide ones, where the lanes are.
void force_any_isa(std::uint64_t number) {
  const auto isas = available_isas();
  force_isa(number % 64 == 0 ? isas[number / 64 % isas.size()] : isas[isas.size() - 1 - number % 2]);
}

int run(int argc, char** argv) {
  CLI::App app{"Random hostile lanes through all of hatbox's samplers."};
  double lanes = 1e9;
  std::uint64_t first = 0;
  unsigned threads = std::max(2u, std::thread::hardware_concurrency());
  app.add_option("--lanes", lanes, "How many lanes to sample")->check(CLI::PositiveNumber);
  app.add_option("--first", first, "The first scene's number");
  app.add_option("--threads", threads, "Host threads")->check(CLI::Range(1, 1024));
  CLI11_PARSE(app, argc, argv);

  Judge judge;
  std::atomic<std::uint64_t> next{first};
  std::atomic<bool> done{false};
  std::vector<std::thread> hosts;
  for (unsigned i = 0; i < threads; ++i) {
    hosts.emplace_back([&] {
      while (static_cast<double>(judge.total().tried) < lanes) soak_scene(next++, judge);
    });
  }
  std::thread forcing([&] {
    for (std::uint64_t i = 0; !done; ++i) {
      force_any_isa(i);
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  });
  for (std::thread& host : hosts) host.join();
  done = true;
  forcing.join();
  judge.print();
  return judge.total().failed == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "hatbox_soak: %s\n", error.what());
    return 1;
  }
}
