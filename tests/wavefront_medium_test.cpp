// Fog in the renderer of bench/wavefront: all ways to sample it must give what a quadrature in double gives.
#include "medium.h"
#include "scattering.h"
#include "support/picture_mean.h"

#include <array>
#include <numbers>
#include <string>

namespace wavefront {
namespace {

using Imath::V3d;

constexpr double sigma_s[3] = {0.2, 0.1, 0.3}, sigma_t[3] = {0.25, 0.2, 0.3};
constexpr double g = 0.4;
constexpr char fog[] = R"(<medium type="homogeneous" id="fog"><rgb name="sigmaT" value="0.25, 0.2, 0.3"/>
  <rgb name="albedo" value="0.8, 0.5, 1"/><phase type="hg"><float name="g" value="0.4"/></phase></medium>
)";

/// A disk of radius ½ and radiance 1 at a height of 2, facing down on a floor of reflectance ½. The camera's ray comes
/// from above the disk's plane, crosses it beside the disk and ends on the floor below.
const V3d camera(3, 4, 0);
constexpr double to_floor = 5, light_height = 2, light_radius = 0.5;

std::string scene_in(const std::string& body, const std::string& in_sensor, const std::string& light) {
  return std::string(fog) + R"(<integrator type="direct"><boolean name="hideEmitters" value="true"/></integrator>
<sensor type="perspective">
  <transform name="toWorld"><lookAt origin="3, 4, 0" target="0, 0, 0" up="0, 1, 0"/></transform>
  <float name="fov" value="0.05"/>)" +
         in_sensor + "</sensor>" + body + R"(<shape type="rectangle">
  <transform name="toWorld"><scale value="50"/><rotate x="1" angle="-90"/></transform>
  <bsdf type="diffuse"><spectrum name="reflectance" value="0.5"/></bsdf>
</shape>
)" + light;
}

const std::string below_disk = R"(<shape type="disk">
  <transform name="toWorld"><scale value="0.5"/><rotate x="1" angle="90"/><translate y="2"/></transform>
  <emitter type="area"/></shape>
)";
const std::string in_fog = "<ref id=\"fog\"/>";

/// ∫ over the light of what reaches `point` along the camera's ray, attenuated; on the floor with its cosine.
double gathered(const V3d& point, const V3d& ray, double extinction, bool floor) {
  constexpr int rings = 24, spokes = 48;
  double sum = 0;
  for (int ring = 0; ring < rings; ++ring)
    for (int spoke = 0; spoke < spokes; ++spoke) {
      const double r = light_radius * std::sqrt((ring + 0.5) / rings);
      const double angle = 2 * std::numbers::pi * (spoke + 0.5) / spokes;
      const V3d way = V3d(r * std::cos(angle), light_height, r * std::sin(angle)) - point;
      const double distance = way.length(), cosine = way.y / distance;
      if (cosine <= 0) continue;
      const double towards = way.dot(ray) / distance;
      const double phase = (1 - g * g) / (4 * std::numbers::pi * std::pow(1 + g * g - 2 * g * towards, 1.5));
      const double scattered = floor ? 0.5 * cosine / std::numbers::pi : phase;
      sum += scattered * cosine * std::exp(-extinction * distance) / (distance * distance);
    }
  return sum * std::numbers::pi * light_radius * light_radius / (rings * spokes);
}

/// The fog begins at `begin` on the ray; the light and all below it are in it.
double expected(int channel, double begin) {
  const V3d ray = (-camera).normalized();
  constexpr int steps = 500;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double t = begin + (to_floor - begin) * (i + 0.5) / steps;
    sum += sigma_s[channel] * std::exp(-sigma_t[channel] * (t - begin)) *
           gathered(camera + ray * t, ray, sigma_t[channel], false);
  }
  return sum * (to_floor - begin) / steps +
         std::exp(-sigma_t[channel] * (to_floor - begin)) * gathered({0, 0, 0}, ray, sigma_t[channel], true);
}

RenderSettings settings_of(Media media, Strategy strategy = Strategy::light) {
  return {.width = 8, .height = 8, .spp = 16, .light_samples = 16, .strategy = strategy, .media = media, .steps = 4};
}

void expect_known_radiance(const Scene& scene, const RenderSettings& settings, double begin) {
  const Image image = render(scene, RayTracer(scene), settings, "").image;
  for (int channel = 0; channel < 3; ++channel)
    expect_agreement(mean_of(image, channel), {expected(channel, begin), 0}, 1e-2);
}

TEST(FogSlow, every_way_to_sample_gives_the_integral) {
  const Scene scene = parse(scene_in("", in_fog, below_disk));
  for (const Media media : {Media::equiangular, Media::area_first, Media::march}) {
    SCOPED_TRACE(name(media));
    expect_known_radiance(scene, settings_of(media), 0);
  }
}

TEST(FogSlow, every_strategy_gives_the_integral) {
  const Scene scene = parse(scene_in("", in_fog, below_disk));
  for (const Media media : {Media::equiangular, Media::march})
    for (const Strategy strategy : {Strategy::bsdf, Strategy::mis}) {
      SCOPED_TRACE(testing::Message() << name(media) << ", " << name(strategy));
      RenderSettings settings = settings_of(media, strategy);
      settings.light_samples = 128;  // few scattering rays meet a light
      expect_known_radiance(scene, settings, 0);
    }
}

/// From a few samples to many of them the standard error falls, and does not stay with something that no sample
/// averages.
void expect_help(const RenderSettings& few, const RenderSettings& many) {
  SCOPED_TRACE(testing::Message() << name(few.media) << ", " << name(few.strategy));
  const Scene scene = parse(scene_in("", in_fog, below_disk));
  EXPECT_LT(mean_of(scene, many).error, mean_of(scene, few).error / 5);
}

/// Distances, steps and directions are of one sequence. Were they not shuffled against each other, a pixel would not
/// converge.
TEST(Fog, more_samples_help) {
  const RenderSettings all[] = {settings_of(Media::equiangular), settings_of(Media::equiangular, Strategy::bsdf),
                                settings_of(Media::march)};
  for (RenderSettings few : all) {
    few.steps = 2;
    few.light_samples = 1;
    RenderSettings many = few;
    many.light_samples = 64;
    expect_help(few, many);
  }
}

/// Light samples alone, more and more paths a pixel.
TEST(Fog, more_paths_help_a_march) {
  RenderSettings few = settings_of(Media::march);
  few.steps = 2;
  few.light_samples = 1;
  few.spp = 4;
  RenderSettings many = few;
  many.spp = 256;
  expect_help(few, many);
}

TEST(Fog, fills_its_body_only) {
  const std::string cube = R"(<shape type="cube"><transform name="toWorld"><scale value="10"/><translate y="-7"/>
    </transform><ref name="interior" id="fog"/></shape>)";  // up to a height of 3: a quarter of the ray is above
  for (const Media media : {Media::equiangular, Media::area_first, Media::march}) {
    SCOPED_TRACE(name(media));
    expect_known_radiance(parse(scene_in(cube, "", below_disk)), settings_of(media), 1.25);
  }
}

/// Of several kinds, both sides of one shining.
const std::string lights = below_disk + R"(<shape type="rectangle">
  <transform name="toWorld"><scale value="0.4"/><rotate z="1" angle="20"/><translate x="1" y="2" z="-1"/></transform>
  <emitter type="area"><rgb name="radiance" value="3, 1, 2"/><boolean name="doubleSided" value="true"/></emitter>
</shape>
<shape type="disk">
  <transform name="toWorld"><scale x="0.3" y="0.7"/><translate x="2" y="1" z="-2"/></transform>
  <emitter type="area"/></shape>
<shape type="cube">
  <transform name="toWorld"><scale value="0.2"/><translate x="2" y="1" z="2"/></transform><emitter type="area"/></shape>
)";

TEST(FogSlow, every_way_to_sample_agrees_for_many_lights) {
  const Scene scene = parse(scene_in("", in_fog, lights));
  const PictureMean march = mean_of(scene, settings_of(Media::march));
  for (const Media media : {Media::equiangular, Media::area_first})
    for (const Choice choice : {Choice::solid_angle, Choice::power, Choice::uniform}) {
      SCOPED_TRACE(testing::Message() << name(media) << ", " << name(choice));
      RenderSettings settings = settings_of(media);
      settings.choice = choice;
      settings.light_samples = 32;
      expect_agreement(mean_of(scene, settings), march, 1e-2);
    }
  expect_agreement(mean_of(scene, settings_of(Media::equiangular, Strategy::mis)), march, 1e-2);
}

TEST(Fog, dims_what_lies_behind_and_lights_that_are_seen) {
  // No light but the one that the camera looks at; what the fog scatters is seen edge-on and from behind: nothing.
  const Scene scene = parse(std::string(fog) + R"(<sensor type="perspective">
  <transform name="toWorld"><lookAt origin="0, 0, 3" target="0, 0, 0"/></transform><float name="fov" value="0.05"/>
  <ref id="fog"/></sensor>
<shape type="disk"><emitter type="area"/></shape>)");
  RenderSettings settings = settings_of(Media::march);
  const Image with_fog = render(scene, RayTracer(scene), settings, "").image;
  Scene absorbing = scene;
  absorbing.medium->sigma_a += absorbing.medium->sigma_s;
  absorbing.medium->sigma_s = Rgb(0.0f);
  const Image image = render(absorbing, RayTracer(absorbing), settings, "").image;
  for (int channel = 0; channel < 3; ++channel) {
    EXPECT_NEAR(mean_of(image, channel).mean, std::exp(-3 * sigma_t[channel]), 1e-5);
    EXPECT_GT(mean_of(with_fog, channel).mean, mean_of(image, channel).mean);
  }
}

TEST(Fog, knows_its_part_of_a_ray) {
  Medium medium{Rgb(1.0f), Rgb(0.0f), 0, {}};
  medium.body = {true, Imath::M44d().setScale(0.5)};  // a ball of radius 2
  const auto expect_interval = [&](const V3f& origin, const V3f& direction, float end, float begin_in, float end_in) {
    const Interval interval = inside(medium, origin, direction, end);
    EXPECT_NEAR(interval.begin, begin_in, 1e-5);
    EXPECT_NEAR(interval.end, end_in, 1e-5);
  };
  const auto expect_none = [&](const V3f& origin, const V3f& direction, float end) {
    const Interval interval = inside(medium, origin, direction, end);
    EXPECT_FALSE(interval.begin < interval.end);
  };
  expect_interval({-5, 0, 0}, {1, 0, 0}, 100, 3, 7);
  expect_interval({0, 0, 0}, {0, 1, 0}, 100, 0, 2);
  expect_interval({-5, 0, 0}, {1, 0, 0}, 4, 3, 4);
  expect_none({-5, 0, 0}, {-1, 0, 0}, 100);
  expect_none({-5, 2, 0}, {1, 0, 0}, 100);
  medium.body->ball = false;
  expect_interval({-5, 1, 1}, {1, 0, 0}, 100, 3, 7);
  expect_none({-5, 2, 1}, {1, 0, 0}, 100);
  expect_none({-5, 1, 1}, {-1, 0, 0}, 100);
  medium.body.reset();
  expect_interval({-5, 1, 1}, {-1, 0, 0}, std::numeric_limits<float>::infinity(), 0, 104);
}

TEST(Scattering, samples_by_its_density) {
  const Scattering all[] = {{true}, {false, 0}, {false, 1e-4f}, {false, 0.7f}, {false, -0.5f}};
  for (const Scattering& scattering : all) {
    const V3f axis = V3f(0.3f, -0.5f, -0.8f).normalized();
    double cosine = 0, expected_cosine = 0, whole = 0;
    constexpr int steps = 256;
    for (int i = 0; i < steps * steps; ++i) {
      const V3f direction = scattering.sample(axis, cell_middle(i, steps));
      ASSERT_NEAR(direction.length(), 1, 1e-6);
      cosine += static_cast<double>(direction.dot(axis)) / (steps * steps);
    }
    for (int i = 0; i < 10000; ++i) {
      const double c = -1 + (i + 0.5) / 5000;
      const double ring = 2 * std::numbers::pi * static_cast<double>(scattering.density(static_cast<float>(c))) / 5000;
      whole += ring;
      expected_cosine += ring * c;
    }
    EXPECT_NEAR(whole, 1, 1e-4);
    EXPECT_NEAR(cosine, expected_cosine, 1e-3);
  }
}

TEST(SceneReader, refuses_media_it_would_get_wrong) {
  const auto expect_error = [](const std::string& body, const std::string& message) {
    const std::string error = error_of(body);
    EXPECT_NE(error.find(message), std::string::npos) << error;
  };
  expect_error("<medium type=\"heterogeneous\" id=\"fog\"/>", "'heterogeneous'");
  expect_error("<medium type=\"homogeneous\" id=\"fog\"/>", "sigmaS and sigmaA are needed");
  expect_error(scene_in("", "<ref id=\"mist\"/>", below_disk), "no medium 'mist'");
  const std::string inside = R"(<ref name="interior" id="fog"/>)";
  expect_error(scene_in("<shape type=\"disk\">" + inside + "</shape>", "", below_disk), "'disk'");
  expect_error(scene_in("<shape type=\"cube\">" + inside + "<bsdf type=\"diffuse\"/></shape>", "", below_disk),
               "no surface");
  const std::string cube = "<shape type=\"cube\">" + inside + "</shape>";
  expect_error(scene_in(cube + cube, "", below_disk), "second body");
}

TEST(Fog, area_first_is_for_light_samples) {
  const Scene scene = parse(scene_in("", in_fog, below_disk));
  EXPECT_THROW(render(scene, RayTracer(scene), settings_of(Media::area_first, Strategy::mis), ""),
               std::invalid_argument);
}

}  // namespace
}  // namespace wavefront
