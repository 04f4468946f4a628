#include "compare.h"

#include "pictures.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <fstream>
#include <optional>
#include <stdexcept>

namespace wavefront {
namespace {

struct Reference {
  Image image;
  double mse;  // of the image itself, estimated
  std::uint32_t spp;
  double seconds;
};

struct Row {
  std::string map;
  Render render;
  std::optional<double> mse;

  double ns_per_light_sample() const {
    return render.light_samples == 0 ? 0 : 1e9 * render.light_seconds / static_cast<double>(render.light_samples);
  }
  double light_stage_share() const { return render.light_seconds / render.seconds; }
};

Reference render_reference(const Scene& scene, const RayTracer& tracer, const Comparison& comparison) {
  RenderSettings settings = comparison.settings;
  settings.sampling = light_sampling("best");
  if (settings.media == Media::area_first) settings.media = Media::equiangular;
  settings.light_samples = (comparison.reference_spp + 2 * settings.spp - 1) / (2 * settings.spp);
  settings.seed = hash(comparison.settings.seed, 1);
  Render first = render(scene, tracer, settings, "reference 1/2");
  settings.seed = hash(comparison.settings.seed, 2);
  const Render second = render(scene, tracer, settings, "reference 2/2");
  const double mse = mean_squared_error(first.image, second.image) / 4;  // variance of a mean of two
  for (std::size_t i = 0; i < first.image.pixels.size(); ++i)
    first.image.pixels[i] = (first.image.pixels[i] + second.image.pixels[i]) * 0.5f;
  return {std::move(first.image), mse, 2 * settings.spp * settings.light_samples, first.seconds + second.seconds};
}

void write_picture(const Image& image, const std::filesystem::path& out, const std::string& name) {
  write_exr(image, out / (name + ".exr"));
  write_png(image, out / (name + ".png"));
}

void print_table(const std::vector<Row>& rows, std::uint32_t spp) {
  std::printf("%-16s %5s %12s %15s %16s %12s %10s\n", "map", "spp", "MSE", "light stage ms", "ns/light sample", "share",
              "seconds");
  for (const Row& row : rows) {
    char mse[32] = "-";
    if (row.mse) std::snprintf(mse, sizeof mse, "%.4e", *row.mse);
    std::printf("%-16s %5u %12s %15.1f %16.2f %10.1f %% %10.3f\n", row.map.c_str(), spp, mse,
                1e3 * row.render.light_seconds, row.ns_per_light_sample(), 100 * row.light_stage_share(),
                row.render.seconds);
  }
}

void write_report(const Comparison& comparison, const std::vector<Row>& rows,
                  const std::optional<Reference>& reference) {
  nlohmann::ordered_json report;
  report["scene"] = comparison.scene_name;
  report["isa"] = hatbox::name(hatbox::active_isa());
  report["width"] = comparison.settings.width;
  report["height"] = comparison.settings.height;
  report["choose"] = name(comparison.settings.choice);
  report["strategy"] = name(comparison.settings.strategy);
  report["media"] = name(comparison.settings.media);
  report["depth"] = comparison.settings.depth;
  if (reference)
    report["reference"] = {{"spp", reference->spp}, {"mse", reference->mse}, {"seconds", reference->seconds}};
  report["rows"] = nlohmann::ordered_json::array();
  for (const Row& row : rows)
    report["rows"].push_back({{"map", row.map},
                              {"spp", comparison.settings.spp},
                              {"mse", row.mse ? nlohmann::ordered_json(*row.mse) : nlohmann::ordered_json()},
                              {"ns_per_light_sample", row.ns_per_light_sample()},
                              {"light_stage_share", row.light_stage_share()},
                              {"seconds", row.render.seconds}});
  const auto path = comparison.out / "report.json";
  std::ofstream file(path);
  if (!(file << report.dump(2) << '\n')) throw std::runtime_error("cannot write " + path.string());
}

/// The maps above, their errors below.
void write_errors(const Comparison& comparison, const std::vector<Row>& rows, const Image& reference) {
  std::vector<Image> errors;
  for (const Row& row : rows) {
    errors.push_back(false_colour_error(row.render.image, reference));
    write_png(errors.back(), comparison.out / (row.map + "_error.png"));
  }
  std::vector<std::vector<const Image*>> tiles(2);
  for (const Row& row : rows) tiles[0].push_back(&row.render.image);
  for (const Image& error : errors) tiles[1].push_back(&error);
  write_png(side_by_side(tiles), comparison.out / "comparison.png");
}

}  // namespace

void compare(const Scene& scene, const Comparison& comparison) {
  for (const LightSampling& sampling : comparison.samplings) {
    RenderSettings settings = comparison.settings;
    settings.sampling = sampling;
    check(scene, settings);  // before the work begins
  }
  const RayTracer tracer(scene);
  std::optional<Reference> reference;
  if (comparison.reference_spp > 0) {
    reference = render_reference(scene, tracer, comparison);
    write_picture(reference->image, comparison.out, "reference");
    std::printf("reference: %u samples a pixel, MSE about %.1e, %.1f s\n", reference->spp, reference->mse,
                reference->seconds);
  }
  std::vector<Row> rows;
  for (const LightSampling& sampling : comparison.samplings) {
    RenderSettings settings = comparison.settings;
    settings.sampling = sampling;
    Row row{sampling.name, render(scene, tracer, settings, sampling.name), {}};
    if (reference) row.mse = mean_squared_error(row.render.image, reference->image);
    write_picture(row.render.image, comparison.out, sampling.name);
    rows.push_back(std::move(row));
  }
  print_table(rows, comparison.settings.spp);
  if (reference) write_errors(comparison, rows, reference->image);
  write_report(comparison, rows, reference);
}

}  // namespace wavefront
