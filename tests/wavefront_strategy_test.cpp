// Light samples, scattering rays and both together must tell the same of every kind of light.
#include "support/picture_mean.h"

#include <fstream>
#include <string>
#include <vector>

namespace wavefront {
namespace {

std::string emitter(bool double_sided) {
  return std::string(R"(<emitter type="area"><rgb name="radiance" value="1, 2, 3"/>
  <boolean name="doubleSided" value=")") +
         (double_sided ? "true" : "false") + "\"/></emitter>";
}

/// Above the patch at the origin, facing down; `steps` come before.
std::string light(const std::string& type, const std::string& steps, bool double_sided = false) {
  return "<shape type=" + type + R"(<transform name="toWorld">)" + steps +
         R"(<rotate x="1" angle="90"/><translate x="0.5" y="1" z="0.2"/></transform>)" + emitter(double_sided) +
         "</shape>\n";
}

std::string obj_type(const ScratchDirectory& scratch) {
  const auto path = scratch.path() / "square.obj";
  std::ofstream(path) << "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv 0 0 0\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";
  return R"("obj"><string name="filename" value=")" + path.string() + "\"/>";
}

RenderSettings settings_of(Strategy strategy, Choice choice = Choice::solid_angle) {
  return {.width = 8, .height = 8, .spp = 16, .light_samples = 32, .choice = choice, .strategy = strategy};
}

void expect_strategies_agree(const Scene& scene) {
  const PictureMean by_light = mean_of(scene, settings_of(Strategy::light));
  for (const Strategy strategy : {Strategy::bsdf, Strategy::mis}) {
    SCOPED_TRACE(name(strategy));
    expect_agreement(mean_of(scene, settings_of(strategy)), by_light, 4e-3);
  }
}

TEST(Strategy, all_agree_for_every_kind_of_light) {
  const ScratchDirectory scratch;
  const std::string kinds[] = {light("\"disk\">", ""), light("\"disk\">", R"(<scale x="1.5" y="0.4"/>)"),
                               light("\"rectangle\">", R"(<scale x="0.5"/>)"), light(obj_type(scratch), "")};
  for (const std::string& kind : kinds) {
    SCOPED_TRACE(kind);
    expect_strategies_agree(parse(patch_under(kind, true)));
  }
}

/// Three lights one behind the other and a pole in front, all of which one ray may meet.
const std::string stack = light("\"disk\">", R"(<scale value="1.2"/>)", true) +
                          light("\"rectangle\">", R"(<translate z="-0.5"/>)") +
                          light("\"disk\">", R"(<scale x="2"/><translate z="0.3"/>)") +
                          light("\"disk\">", R"(<rotate x="1" angle="180"/><translate z="0.1"/>)") +
                          R"(<shape type="sphere"><point name="center" x="-0.4" y="0.3"/>
  <float name="radius" value="0.2"/></shape>)";

TEST(Strategy, all_agree_for_lights_behind_each_other_hidden_or_not) {
  expect_strategies_agree(parse(patch_under(stack, true)));
  Scene scene = parse(patch_under(stack, false));
  scene.view.to_world = parse(R"(<sensor type="perspective"><transform name="toWorld">
    <lookAt origin="-3, 0.4, 0" target="0, 0, 0" up="0, 1, 0"/></transform></sensor>)" +
                              stack)
                            .view.to_world;  // below the lights, which the camera would see otherwise
  expect_strategies_agree(scene);
}

TEST(Strategy, light_choices_agree) {
  const Scene scene = parse(patch_under(stack, true));
  const PictureMean by_solid_angle = mean_of(scene, settings_of(Strategy::light));
  for (const Choice choice : {Choice::uniform, Choice::power})
    for (const Strategy strategy : {Strategy::light, Strategy::mis})
      expect_agreement(mean_of(scene, settings_of(strategy, choice)), by_solid_angle, 4e-3);
}

/// Half of the directions to a wide light are so slanted that they bring little; scattering rays know.
TEST(Strategy, mis_helps_next_to_a_large_light) {
  const Scene scene = parse(patch_under(light("\"disk\">", R"(<scale value="30"/>)"), true));
  const auto variance = [&](Strategy strategy, std::uint32_t samples) {
    RenderSettings settings = settings_of(strategy);
    settings.width = settings.height = 32;
    settings.spp = 1;
    settings.light_samples = samples;
    settings.sampler = SamplerKind::random;
    return std::pow(mean_of(scene, settings).error, 2);
  };
  EXPECT_LT(variance(Strategy::mis, 8), 0.5 * variance(Strategy::light, 16));  // as many samples in all
}

TEST(Strategy, mis_needs_a_density) {
  const Scene scene = parse(patch_under(light("\"disk\">", ""), true));
  RenderSettings settings = settings_of(Strategy::mis);
  settings.sampling = light_sampling("auto");
  EXPECT_THROW(mean_of(scene, settings), std::invalid_argument);
}

TEST(Strategy, the_same_seed_makes_the_same_picture) {
  const Scene scene = parse(patch_under(stack, true));
  const RayTracer tracer(scene);
  RenderSettings settings = settings_of(Strategy::mis);
  settings.light_samples = 4;
  const Image first = render(scene, tracer, settings, "").image;
  EXPECT_EQ(first.pixels, render(scene, tracer, settings, "").image.pixels);
  settings.seed = 1;
  EXPECT_NE(first.pixels, render(scene, tracer, settings, "").image.pixels);
}

}  // namespace
}  // namespace wavefront
