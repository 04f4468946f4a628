// How the renderer in bench/wavefront chooses among lights.
#include "light_stage.h"
#include "support/picture_mean.h"
#include "support/random.h"
#include "support/scene_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace wavefront {
namespace {

/// A 3 × 2 rectangle made of two triangles, a disk and an ellipse, a rectangle that shines to both sides.
Scene scene_of_lights() {
  Scene scene = parse(sensor + R"(<shape type="sphere"/>
<shape type="disk"><transform name="toWorld"><translate z="-3"/></transform>
  <emitter type="area"><rgb name="radiance" value="1, 2, 3"/></emitter></shape>
<shape type="disk"><transform name="toWorld"><scale x="0.5"/><translate x="4"/></transform>
  <emitter type="area"><rgb name="radiance" value="0, 5, 0"/></emitter></shape>
<shape type="rectangle"><transform name="toWorld"><rotate y="1" angle="90"/><translate x="-5"/></transform>
  <emitter type="area"><boolean name="doubleSided" value="true"/></emitter></shape>)");
  const MeshLight mesh{{{{0, 0, 0}, {3, 0, 0}, {3, 2, 0}}, {{0, 0, 0}, {3, 2, 0}, {0, 2, 0}}}, {0, 1}};
  scene.emitters.push_back({mesh, Rgb(1.0f), true});
  return scene;
}

/// The mesh alone.
Scene scene_of_mesh() {
  Scene scene = scene_of_lights();
  scene.emitters.erase(scene.emitters.begin(), scene.emitters.begin() + 3);
  scene.shapes.clear();
  return scene;
}

/// Samples from more points than a block has.
struct Sampled {
  static constexpr std::size_t n = 5000, k = 2;

  Sampled(const Scene& scene_, Choice choice, const char* map)
      : scene(scene_),
        settings{
            .width = 1, .height = 1, .spp = 1, .light_samples = k, .sampling = light_sampling(map), .choice = choice} {
    vertices.scattering = {.surface = true};
    vertices.open(1, n);
    hatbox::test::Random random(7);
    for (std::size_t i = 0; i < n; ++i) {
      vertices.add(0);
      vertices.position.set(i, {8 * random.unit_float() - 4, 8 * random.unit_float() - 4, 6 * random.unit_float() - 3});
      vertices.path[i] = static_cast<std::uint32_t>(i);
      vertices.sequence[i] = 0;
      vertices.light[i] = any_light;
    }
    vertices.close();
    stage_of_lights.sample(vertices, Dimension::light, k, samples);
  }

  V3f end(std::size_t sample) const {
    return vertices.position[sample % n] + samples.direction[sample] * samples.distance[sample];
  }

  const Scene scene;
  const RayTracer tracer{scene};
  const LightTable lights{scene};
  const RenderSettings settings;
  const Sampler sampler{SamplerKind::random, k};
  const Stage stage{scene, tracer, lights, settings, sampler, 1};
  VertexQueue vertices;
  ConnectionQueue samples;
  LightStage stage_of_lights{stage};
};

TEST(LightChoice, by_solid_angle_makes_the_density_of_a_mesh_uniform) {
  const Sampled s(scene_of_mesh(), Choice::solid_angle, "best");
  std::vector<float> omega(Sampled::n);
  hatbox::solid_angle(hatbox::Rectangle{{0, 0, 0}, {3, 0, 0}, {0, 2, 0}}, s.vertices.position.points(), omega);
  for (std::size_t i = 0; i < s.samples.size(); ++i) {
    ASSERT_NEAR(s.samples.probability[i] * s.samples.pdf[i] * omega[i % Sampled::n], 1, 2e-5) << i;
    const V3f end = s.end(i);
    ASSERT_TRUE(end.x > -1e-5f && end.x < 3 + 1e-5f && end.y > -1e-5f && end.y < 2 + 1e-5f) << end;
    ASSERT_NEAR(end.z, 0, 1e-5f);
  }
}

TEST(LightChoice, by_power_makes_the_density_of_the_area_uniform) {
  const Sampled s(scene_of_mesh(), Choice::power, "area");
  for (std::size_t i = 0; i < s.samples.size(); ++i) {
    const float distance = s.samples.distance[i], density = s.samples.probability[i] * s.samples.pdf[i];
    ASSERT_NEAR(density * 6 * std::abs(s.samples.cosine[i]) / (distance * distance), 1, 2e-5) << i;
  }
}

TEST(LightChoice, its_probability_is_its_frequency_and_nothing_is_wasted_behind_a_light) {
  for (const Choice choice : {Choice::uniform, Choice::power, Choice::solid_angle}) {
    const Sampled s(scene_of_lights(), choice, "best");
    ASSERT_EQ(s.lights.size(), 5u);
    double inverse = 0;
    std::vector<int> counts(5);
    for (std::size_t i = 0; i < s.samples.size(); ++i) {
      ASSERT_GT(s.samples.probability[i], 0);
      inverse += 1 / static_cast<double>(s.samples.probability[i]);
      const LightFacts& light = s.lights[s.samples.light[i]];
      ++counts[s.samples.light[i]];
      ASSERT_TRUE(choice != Choice::solid_angle || light.double_sided || s.samples.cosine[i] > 0);
    }
    // Σ 1/q over samples counts the lights that can be chosen: five, or those that shine on a point.
    double expected = 0;
    for (std::size_t i = 0; i < Sampled::n; ++i)
      for (std::uint32_t light = 0; light < 5; ++light)
        expected += choice != Choice::solid_angle || s.lights[light].shines_on(s.vertices.position[i]) ? 1 : 0;
    EXPECT_NEAR(inverse / static_cast<double>(Sampled::k) / expected, 1, 0.05);
    for (const int count : counts) EXPECT_GT(count, 0);
  }
}

TEST(LightChoice, the_density_of_a_direction_found_otherwise_is_that_of_the_sample) {
  for (const Choice choice : {Choice::uniform, Choice::power, Choice::solid_angle}) {
    Sampled s(scene_of_lights(), choice, "best");
    std::vector<float> density(Sampled::n);
    const auto first = [](auto& all) { return std::span(all).first(Sampled::n); };
    s.stage_of_lights.density(
        s.vertices.position.points(),
        {first(s.samples.direction.x), first(s.samples.direction.y), first(s.samples.direction.z)},
        first(s.samples.light), s.samples.total, s.vertices.light, density);
    int misses = 0;
    for (std::size_t i = 0; i < Sampled::n; ++i) {
      const float expected = s.samples.probability[i] * s.samples.pdf[i];
      if (std::abs(density[i] - expected) > 1e-4f * expected) ++misses;
    }
    EXPECT_LT(misses, 5);  // a float direction cannot tell next to a rim, or seen edge-on
  }
}

TEST(LightFacts, places_are_on_the_light_and_uniform) {
  const LightTable lights(scene_of_lights());
  for (std::uint32_t light = 0; light < lights.size(); ++light) {
    V3f mean(0);
    constexpr int steps = 200;
    for (int i = 0; i < steps * steps; ++i) {
      const V3f place = lights[light].place(cell_middle(i, steps));
      ASSERT_NEAR(lights[light].normal.dot(place - lights[light].centre), 0, 1e-5f);
      mean += place / (steps * steps);
    }
    expect_near(mean, lights[light].centre, 2e-3f);
  }
  EXPECT_NEAR(lights[0].area, M_PI, 1e-5);
  EXPECT_NEAR(lights[1].area, M_PI / 2, 1e-5);
  EXPECT_NEAR(lights[2].area, 4, 1e-5);
  EXPECT_NEAR(lights[3].area, 3, 1e-5);
}

template <class Function>
void expect_error(Function function, const std::string& known) {
  try {
    function();
    FAIL() << "took an unknown name";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("'any' (known: " + known + ")"), std::string::npos) << error.what();
  }
}

TEST(Names, unknown_ones_are_errors_that_list_the_known) {
  EXPECT_EQ(choice_named("solid-angle"), Choice::solid_angle);
  EXPECT_EQ(strategy_named("mis"), Strategy::mis);
  EXPECT_EQ(media_named("area-first"), Media::area_first);
  expect_error([] { choice_named("any"); }, "uniform, power, solid-angle");
  expect_error([] { strategy_named("any"); }, "light, bsdf, mis");
  expect_error([] { media_named("any"); }, "equiangular, area-first, march");
}

}  // namespace
}  // namespace wavefront
