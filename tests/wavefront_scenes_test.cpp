// The scenes that come with the renderer in bench/wavefront, and the one of the paper's authors if it is there.
#include "light_table.h"
#include "support/picture_mean.h"

#include <filesystem>

namespace wavefront {
namespace {

/// Finite, nowhere negative, and not black.
void expect_picture(const Image& image) {
  double sum = 0;
  for (const Rgb& pixel : image.pixels)
    for (int channel = 0; channel < 3; ++channel) {
      ASSERT_TRUE(std::isfinite(pixel[channel]) && pixel[channel] >= 0) << pixel;
      sum += static_cast<double>(pixel[channel]);
    }
  EXPECT_GT(sum / static_cast<double>(image.pixels.size()), 0.01);
}

RenderSettings tiny(Strategy strategy, Media media) {
  return {.width = 64, .height = 48, .spp = 4, .strategy = strategy, .media = media, .steps = 2};
}

TEST(ScenesSlow, many_lights_are_64_of_every_kind) {
  const Scene scene = read_scene(std::filesystem::path(WAVEFRONT_SCENES) / "many-lights.xml");
  EXPECT_TRUE(scene.ignored.empty());
  EXPECT_EQ(LightTable(scene).size(), 64u);
  std::size_t kinds[std::variant_size_v<Light>] = {};
  for (const Emitter& emitter : scene.emitters) ++kinds[emitter.light.index()];
  for (const std::size_t kind : kinds) EXPECT_GT(kind, 0u);
  const RayTracer tracer(scene);
  for (const Choice choice : {Choice::uniform, Choice::power, Choice::solid_angle}) {
    RenderSettings settings = tiny(Strategy::mis, Media::equiangular);
    settings.choice = choice;
    expect_picture(render(scene, tracer, settings, "").image);
  }
}

/// By a picture of the same scene with more samples.
double error_of(const Scene& scene, const RayTracer& tracer, const Image& reference, Choice choice) {
  RenderSettings settings = tiny(Strategy::light, Media::equiangular);
  settings.choice = choice;
  return mean_squared_error(render(scene, tracer, settings, "").image, reference);
}

TEST(ScenesSlow, many_lights_are_better_chosen_by_solid_angle) {
  const Scene scene = read_scene(std::filesystem::path(WAVEFRONT_SCENES) / "many-lights.xml");
  const RayTracer tracer(scene);
  RenderSettings settings = tiny(Strategy::light, Media::equiangular);
  settings.light_samples = 64;
  settings.seed = 1;
  const Image reference = render(scene, tracer, settings, "").image;
  EXPECT_LT(error_of(scene, tracer, reference, Choice::solid_angle),
            0.25 * error_of(scene, tracer, reference, Choice::uniform));
}

void expect_fog(const Scene& scene) {
  ASSERT_TRUE(scene.medium && scene.medium->body);
  EXPECT_EQ(scene.medium->sigma_s, Rgb(0.05f));
  EXPECT_EQ(scene.medium->sigma_a, Rgb(0.05f));
  EXPECT_EQ(scene.medium->g, 0);
  const RayTracer tracer(scene);
  for (const Media media : {Media::equiangular, Media::area_first, Media::march}) {
    expect_picture(render(scene, tracer, tiny(Strategy::light, media), "").image);
    if (media != Media::area_first) expect_picture(render(scene, tracer, tiny(Strategy::mis, media), "").image);
  }
}

TEST(Scenes, medium_renders) {
  const Scene scene = read_scene(std::filesystem::path(WAVEFRONT_SCENES) / "medium.xml");
  EXPECT_TRUE(scene.ignored.empty());
  expect_fog(scene);
}

/// The paper's Figure 8: area sampling loses even with its better strategy, and far more without.
TEST(ScenesSlow, medium_wants_solid_angle_sampling) {
  const Scene scene = read_scene(std::filesystem::path(WAVEFRONT_SCENES) / "medium.xml");
  const RayTracer tracer(scene);
  RenderSettings settings = tiny(Strategy::light, Media::equiangular);
  settings.width = 96;
  settings.height = 72;
  settings.spp = 16;
  const auto picture = [&](const char* map, std::uint32_t samples, std::uint64_t seed) {
    settings.sampling = light_sampling(map);
    settings.light_samples = samples;
    settings.seed = seed;
    return render(scene, tracer, settings, "").image;
  };
  const Image reference = picture("best", 8, 1);
  const double area_first = mean_squared_error(picture("area_first", 1, 0), reference);
  EXPECT_GT(mean_squared_error(picture("area", 1, 0), reference), 2 * area_first);
  EXPECT_GT(area_first, 10 * mean_squared_error(picture("ld_radial", 1, 0), reference));
}

#ifdef PUBLISHED_SCENE
TEST(Scenes, the_bunny_of_the_authors_renders_as_it_stands) {
  const Scene scene = read_scene(PUBLISHED_SCENE);
  EXPECT_EQ(scene.shapes.size(), 3u);  // without the body of the fog
  expect_fog(scene);
}
#endif

}  // namespace
}  // namespace wavefront
