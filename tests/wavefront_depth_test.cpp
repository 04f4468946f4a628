// Light after bounces: against a quadrature of what a ceiling lit from below sheds on the ground, and by powers of the
// reflectance.
#include "reference/irradiance.h"
#include "support/picture_mean.h"

#include <gtest/gtest.h>

#include <numbers>
#include <string>

namespace wavefront {
namespace {

std::string diffuse(double reflectance) {
  return R"(<bsdf type="diffuse"><spectrum name="reflectance" value=")" + std::to_string(reflectance) + R"("/></bsdf>)";
}

/// A patch at the origin under a square ceiling at y = 2. The light at y = 1 shines up: on the ceiling alone.
Scene indirect_light(double ground, double ceiling) {
  return parse(R"(<integrator type="direct"><boolean name="hideEmitters" value="true"/></integrator>
<sensor type="perspective">
  <transform name="toWorld"><lookAt origin="0, 0.5, 0" target="0, 0, 0" up="0, 0, 1"/></transform>
  <float name="fov" value="0.1"/>
</sensor>
<shape type="rectangle"><transform name="toWorld"><rotate x="1" angle="-90"/></transform>)" +
               diffuse(ground) + R"(</shape>
<shape type="rectangle"><transform name="toWorld"><rotate x="1" angle="90"/><translate y="2"/></transform>)" +
               diffuse(ceiling) + R"(</shape>
<shape type="disk">
  <transform name="toWorld"><rotate x="1" angle="-90"/><scale value="0.5"/><translate x="1.5" y="1"/></transform>
  <emitter type="area"><spectrum name="radiance" value="1"/></emitter>
</shape>)");
}

/// What the origin gets from the ceiling after one bounce there, for a reflectance of 1 of both.
double bounced_once() {
  constexpr int steps = 100;
  const hatbox::Disk light{{1.5f, 1, 0}, {0, 1, 0}, 0.5f};
  double sum = 0;
  for (int cell = 0; cell < steps * steps; ++cell) {
    const Sample2 middle = cell_middle(cell, steps);
    const hatbox::Vec3 at{2 * middle.x - 1, 2, 2 * middle.y - 1};
    const double x = double{at.x}, z = double{at.z}, squared = x * x + 4 + z * z;
    const double lit = hatbox::reference::irradiance(light, at, {0, -1, 0}) / std::numbers::pi;
    sum += lit * 4 / (squared * squared) * 4.0 / (steps * steps);  // cos · cos / r² = 4/r⁴; an area of 4
  }
  return sum / std::numbers::pi;
}

RenderSettings settings_of(std::uint32_t depth, Strategy strategy = Strategy::light) {
  return {.width = 16, .height = 16, .spp = 64, .light_samples = 4, .strategy = strategy, .depth = depth};
}

TEST(Depth, light_after_a_bounce_is_that_of_a_quadrature) {
  const Scene scene = indirect_light(0.5, 0.8);
  EXPECT_EQ(mean_of(scene, settings_of(1)).mean, 0);
  for (const Strategy strategy : {Strategy::light, Strategy::bsdf, Strategy::mis}) {
    SCOPED_TRACE(name(strategy));
    RenderSettings settings = settings_of(2, strategy);
    if (strategy == Strategy::bsdf) settings.light_samples = 64;  // few of its rays meet the light
    expect_agreement(mean_of(scene, settings), {0.5 * 0.8 * bounced_once(), 0}, 2e-2);
  }
}

TEST(Depth, paths_of_three_bounces_go_by_the_reflectances) {
  // The ceiling alone is lit, so what paths gather at their fourth vertex went ceiling, ground, ceiling, ground.
  const auto beyond_the_first = [](double ground, double ceiling) {
    const Scene scene = indirect_light(ground, ceiling);
    return mean_of(scene, settings_of(4)).mean - mean_of(scene, settings_of(2)).mean;
  };
  const double full = beyond_the_first(1, 1);
  EXPECT_GT(full, 0.02 * bounced_once());
  EXPECT_NEAR(beyond_the_first(0.5, 0.8), 0.5 * 0.5 * 0.8 * 0.8 * full, 1e-4 * full);
}

TEST(Depth, refuses_what_it_cannot_do) {
  EXPECT_THROW(mean_of(indirect_light(1, 1), settings_of(0)), std::invalid_argument);
  Scene fog = indirect_light(1, 1);
  fog.medium.emplace();
  EXPECT_THROW(mean_of(fog, settings_of(2)), std::invalid_argument);
}

TEST(Depth, pictures_of_other_seeds_have_the_same_paths) {
  // Then all they differ by are light samples: far less than what the directions of bounces differ by.
  const Scene scene = indirect_light(0.5, 0.8);
  const RayTracer tracer(scene);
  RenderSettings settings = settings_of(2);
  settings.light_samples = 64;
  const Image first = render(scene, tracer, settings, "").image;
  settings.seed = 1;
  const Image second = render(scene, tracer, settings, "").image;
  EXPECT_NE(first.pixels, second.pixels);
  const PictureMean of_pixels = mean_of(first);
  const double deviation = of_pixels.error * std::sqrt(static_cast<double>(first.pixels.size()));
  EXPECT_LT(std::sqrt(mean_squared_error(first, second)), 0.1 * deviation);
}

}  // namespace
}  // namespace wavefront
