// wavefront SCENE --compare area,radial,ld_radial --spp 16 --reference-spp 1024 --size 640x480 --out DIR
#include "compare.h"
#include "scene_reader.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <CLI/CLI.hpp>

#include <charconv>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace {

struct Options {
  std::string scene;
  std::string map = "best";
  std::vector<std::string> compare;
  std::uint32_t spp = 0;  // 0: as the scene says
  std::uint32_t reference_spp = 1024;
  std::pair<int, int> size = {0, 0};
  std::string out = ".";
  std::string sampler = "zero_two";
  std::string choose = "solid-angle";
  std::string strategy = "light";
  std::string media = "equiangular";
  std::uint32_t steps = 4;
  std::uint32_t depth = 1;
  std::uint64_t seed = 0;
  int threads = tbb::info::default_concurrency();
};

std::pair<int, int> parse_size(const std::string& text) {
  std::pair<int, int> size;
  const char* const end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size.first);
  const bool has_x = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
  const auto height = has_x ? std::from_chars(width.ptr + 1, end, size.second) : width;
  constexpr int largest = 16384;
  if (!has_x || height.ec != std::errc() || height.ptr != end || size.first < 1 || size.second < 1 ||
      size.first > largest || size.second > largest)
    throw CLI::ValidationError("--size", "must be WIDTHxHEIGHT, such as 640x480, not '" + text + "'");
  return size;
}

void add_options(CLI::App& app, Options& options) {
  app.add_option("scene", options.scene, "Scene file (a subset of Mitsuba 0.5's XML)")->required();
  auto* map = app.add_option("--map", options.map, "How to sample lights: " + wavefront::light_sampling_names())
                  ->capture_default_str();
  app.add_option("--compare", options.compare, "Render a reference and these maps, separated by commas")
      ->delimiter(',')
      ->excludes(map);
  app.add_option("--spp", options.spp, "Samples a pixel; as in the scene if not given")->check(CLI::Range(1, 1 << 16));
  app.add_option("--reference-spp", options.reference_spp, "Samples a pixel of the reference")
      ->check(CLI::Range(1, 1 << 17))
      ->capture_default_str();
  app.add_option_function<std::string>(
      "--size", [&](const std::string& text) { options.size = parse_size(text); },
      "WIDTHxHEIGHT; as in the scene if not given");
  app.add_option("--out", options.out, "Directory for the pictures and report.json")->capture_default_str();
  app.add_option("--sampler", options.sampler, "zero_two or random")
      ->check(CLI::IsMember({"zero_two", "random"}))
      ->capture_default_str();
  app.add_option("--choose", options.choose, "What lights are chosen by: " + wavefront::choice_names())
      ->capture_default_str();
  app.add_option("--strategy", options.strategy, "Where directions come from: " + wavefront::strategy_names())
      ->capture_default_str();
  app.add_option("--media", options.media, "Where on a ray a medium is sampled: " + wavefront::media_names())
      ->capture_default_str();
  app.add_option("--steps", options.steps, "Steps of a march through a medium")
      ->check(CLI::Range(1, 1 << 10))
      ->capture_default_str();
  app.add_option("--depth", options.depth, "Surfaces of a path that gather light; 1: direct light alone")
      ->check(CLI::Range(1, 1 << 10))
      ->capture_default_str();
  app.add_option("--seed", options.seed, "Seed of the light samples")->capture_default_str();
  app.add_option("--threads", options.threads, "Threads")->check(CLI::Range(1, 4096))->capture_default_str();
}

void run(const Options& options) {
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(options.threads));
  wavefront::Comparison comparison;
  comparison.scene_name = options.scene;
  for (const std::string& map : options.compare.empty() ? std::vector{options.map} : options.compare)
    comparison.samplings.push_back(wavefront::light_sampling(map));
  comparison.reference_spp = options.compare.empty() ? 0 : options.reference_spp;
  comparison.out = options.out;

  const wavefront::Scene scene = wavefront::read_scene(options.scene);
  if (!scene.ignored.empty()) {
    std::string list;
    for (const std::string& property : scene.ignored) list += (list.empty() ? "" : ", ") + property;
    std::fprintf(stderr, "note: %s: ignored: %s\n", options.scene.c_str(), list.c_str());
  }
  const bool own_size = options.size.first > 0;
  comparison.settings = {
      .width = own_size ? options.size.first : scene.width,
      .height = own_size ? options.size.second : scene.height,
      .spp = options.spp > 0 ? options.spp : scene.samples_per_pixel,
      .choice = wavefront::choice_named(options.choose),
      .strategy = wavefront::strategy_named(options.strategy),
      .media = wavefront::media_named(options.media),
      .steps = options.steps,
      .depth = options.depth,
      .sampler = options.sampler == "random" ? wavefront::SamplerKind::random : wavefront::SamplerKind::zero_two,
      .seed = options.seed};
  std::filesystem::create_directories(comparison.out);
  wavefront::compare(scene, comparison);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    CLI::App app("Renders direct light from area lights, sampled by hatbox, and measures the error.", "wavefront");
    Options options;
    add_options(app, options);
    try {
      app.parse(argc, argv);
    } catch (const CLI::Success& help) {
      return app.exit(help);
    } catch (const CLI::ParseError& error) {
      std::fprintf(stderr, "wavefront: %s\n", error.what());
      return 2;
    }
    run(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "wavefront: %s\n", error.what());
    return 1;
  }
}
