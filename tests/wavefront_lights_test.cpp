// Rectangles, meshes and ellipses as lights of the renderer in bench/wavefront.
#include "compare.h"
#include "support/scene_text.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <numbers>
#include <string>

namespace wavefront {
namespace {

constexpr char emitter[] = R"(<emitter type="area"><rgb name="radiance" value="1, 2, 3"/></emitter>)";

/// A rectangle's shape with an emitter; the steps of its transform as given.
std::string rectangle(const std::string& steps) {
  return R"(<shape type="rectangle"><transform name="toWorld">)" + steps + "</transform>" + emitter + "</shape>\n";
}

/// The same from an OBJ file.
std::string obj(const std::filesystem::path& path, const std::string& steps) {
  return R"(<shape type="obj"><string name="filename" value=")" + path.string() + R"("/><transform name="toWorld">)" +
         steps + "</transform>" + emitter + "</shape>\n";
}

/// Mitsuba's rectangle as two triangles, and one without an area.
std::filesystem::path write_square(const ScratchDirectory& scratch) {
  const auto path = scratch.path() / "square.obj";
  std::ofstream(path) << "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv 0 0 0\nf 1 2 3\nf 1 3 4\nf 1 5 3\n";
  return path;
}

TEST(SceneReader, reads_a_rectangle_light) {
  const std::string turn = R"(<rotate x="1" angle="90"/><translate x="1" y="3" z="-4"/>)";
  for (const char* scale : {R"(<scale x="3" y="2"/>)", R"(<scale x="-3" y="2"/>)"}) {
    const Scene scene = parse(sensor + rectangle(scale + turn));
    const auto& light = std::get<hatbox::Rectangle>(scene.emitters.at(0).light);
    const V3f u = to_v3f(light.edge_u), v = to_v3f(light.edge_v);
    expect_near(to_v3f(light.corner) + (u + v) * 0.5f, {1, 3, -4}, 1e-6f);
    expect_near(u.cross(v), {0, -24, 0}, 1e-5f);  // a mirror turns no normal
    EXPECT_EQ(scene.emitters[0].radiance, Rgb(1, 2, 3));
  }
}

TEST(SceneReader, skips_triangles_without_an_area) {
  const ScratchDirectory scratch;
  const Scene scene = parse(sensor + obj(write_square(scratch), R"(<scale x="3" y="2"/><rotate x="1" angle="90"/>)"));
  const auto& light = std::get<MeshLight>(scene.emitters.at(0).light);
  ASSERT_EQ(light.triangles.size(), 2u);
  const V3f a = to_v3f(light.triangles[0].a);
  const V3f normal = (to_v3f(light.triangles[0].b) - a).cross(to_v3f(light.triangles[0].c) - a);
  expect_near(normal, {0, -24, 0}, 1e-5f);
  ASSERT_EQ(scene.ignored.size(), 1u);
  EXPECT_EQ(scene.ignored[0], "1 degenerate triangle(s) of the obj light (line 6)");
}

TEST(SceneReader, a_mirror_does_not_turn_the_light_of_a_mesh_with_normals) {
  const ScratchDirectory scratch;
  const auto path = scratch.path() / "triangle.obj";
  std::ofstream(path) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n";
  const Scene scene = parse(sensor + obj(path, R"(<scale x="-1"/>)"));
  const hatbox::Triangle& light = std::get<MeshLight>(scene.emitters.at(0).light).triangles.at(0);
  expect_near((to_v3f(light.b) - to_v3f(light.a)).cross(to_v3f(light.c) - to_v3f(light.a)), {0, 0, 1}, 1e-6f);
}

TEST(SceneReader, refuses_what_cannot_be_a_light) {
  const std::string sheared = error_of(sensor + rectangle(R"(<scale x="3"/><rotate z="1" angle="30"/><scale x="2"/>)"));
  EXPECT_NE(sheared.find("test.xml:6: <shape>: this rectangle cannot be a light"), std::string::npos) << sheared;
  EXPECT_NE(sheared.find("not perpendicular"), std::string::npos) << sheared;
  const std::string sphere = error_of(sensor + "<shape type=\"sphere\">" + emitter + "</shape>");
  EXPECT_NE(sphere.find("test.xml:6: <shape>: only a disk"), std::string::npos) << sphere;

  const ScratchDirectory scratch;
  const auto path = scratch.path() / "line.obj";
  std::ofstream(path) << "v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n";
  const std::string line = error_of(sensor + obj(path, ""));
  EXPECT_NE(line.find("test.xml:6: <shape>: this obj cannot be a light"), std::string::npos) << line;
}

TEST(LightSampling, names_the_maps_that_suit) {
  const Scene scene = parse(sensor + rectangle(""));
  EXPECT_NO_THROW(check_suits(light_sampling("spherical"), scene));
  for (const char* map : {"radial", "table"}) try {
      check_suits(light_sampling(map), scene);
      FAIL() << "sampled a rectangle by a map of disks";
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(std::string("'") + map + "' is not for"), std::string::npos)
          << error.what();
      EXPECT_NE(std::string(error.what()).find("(known: best, area, area_first, spherical"), std::string::npos)
          << error.what();
    }
}

TEST(LightSampling, leaves_other_kinds_their_best_map) {
  const Scene scene = parse(sensor + rectangle("") + R"(<shape type="disk">)" + emitter + "</shape>");
  const LightSampling radial = light_sampling("radial");
  EXPECT_NO_THROW(check_suits(radial, scene));
  EXPECT_EQ(radial.maps.disk, hatbox::DiskMap::radial);
  EXPECT_EQ(radial.maps.ellipse, hatbox::EllipseMap::radial);
  EXPECT_EQ(radial.maps.rectangle, hatbox::RectangleMap::spherical);
  EXPECT_THROW(check_suits(light_sampling("table"), scene), std::invalid_argument);  // for an only light
}

TEST(SceneReader, a_stretched_disk_is_an_ellipse) {
  // Stretched along a diagonal, so that no axis of the square is one of the ellipse; with a mirror and a turn.
  const std::string steps =
      R"(<rotate z="1" angle="30"/><scale x="-3" y="2"/><rotate x="1" angle="90"/><translate x="1" y="3" z="-4"/>)";
  const Scene scene = parse(sensor + R"(<shape type="disk"><transform name="toWorld">)" + steps + "</transform>" +
                            emitter + "</shape>");
  const auto& light = std::get<hatbox::Ellipse>(scene.emitters.at(0).light);
  const V3f u = to_v3f(light.semi_axis_u), v = to_v3f(light.semi_axis_v);
  expect_near(to_v3f(light.center), {1, 3, -4}, 1e-6f);
  expect_near({std::abs(u.x), std::abs(u.y), std::abs(u.z)}, {3, 0, 0}, 1e-5f);
  expect_near({std::abs(v.x), std::abs(v.y), std::abs(v.z)}, {0, 0, 2}, 1e-5f);
  expect_near(u.cross(v), {0, -6, 0}, 1e-5f);
}

/// Half of the irradiance that a rectangle of radiance one makes at a distance of one under a corner, its sides x and
/// y.
double under_corner(double x, double y) {
  const double a = std::sqrt(1 + x * x), b = std::sqrt(1 + y * y);
  return (x / a * std::atan(y / a) + y / b * std::atan(x / b)) / 2;
}

/// Two wide, one deep and askew over the patch: x from -0.5 to 1.5, z from -0.3 to 0.7 at a height of one.
constexpr char over_the_patch[] = R"(<scale y="0.5"/><rotate x="1" angle="90"/><translate x="0.5" y="1" z="0.2"/>)";

RenderSettings small_settings(const char* map, Choice choice) {
  return {.width = 5, .height = 3, .spp = 16, .light_samples = 16, .sampling = light_sampling(map), .choice = choice};
}

/// The pixels' own randomisations make them independent: their mean errs by their deviation over √15, and five times
/// that happens once in 5000. What the picture itself bends is 1e-5.
void expect_irradiance(const Scene& scene, const RenderSettings& settings) {
  const double expected =
      (under_corner(1.5, 0.7) - under_corner(-0.5, 0.7) - under_corner(1.5, -0.3) + under_corner(-0.5, -0.3)) * 0.5 /
      std::numbers::pi;
  const Image image = render(scene, RayTracer(scene), settings, "").image;
  double sum = 0, sum_of_squares = 0;
  for (const Rgb& pixel : image.pixels) {
    sum += static_cast<double>(pixel.x);
    sum_of_squares += static_cast<double>(pixel.x) * static_cast<double>(pixel.x);
    EXPECT_NEAR(pixel.z, 3 * pixel.x, 1e-5);
  }
  const double n = static_cast<double>(image.pixels.size()), mean = sum / n;
  const double error = std::sqrt((sum_of_squares / n - mean * mean) / (n - 1));
  EXPECT_LT(error, 2e-3 * expected);
  EXPECT_NEAR(mean, expected, 5 * error + 2e-5 * expected);
}

TEST(Render, a_rectangle_light_gives_the_known_irradiance) {
  const Scene scene = parse(patch_under(rectangle(over_the_patch), true));
  for (const char* map : {"best", "area", "spherical"}) {
    SCOPED_TRACE(map);
    expect_irradiance(scene, small_settings(map, Choice::solid_angle));
  }
}

TEST(Render, a_mesh_light_gives_the_irradiance_of_its_rectangle) {
  const ScratchDirectory scratch;
  const Scene scene = parse(patch_under(obj(write_square(scratch), over_the_patch), true));
  for (const char* map : {"area", "spherical"}) {
    for (const Choice choice : {Choice::solid_angle, Choice::power, Choice::uniform}) {
      SCOPED_TRACE(std::string(map) + ", " + name(choice));
      expect_irradiance(scene, small_settings(map, choice));
    }
  }
}

TEST(Render, rectangle_and_mesh_lights_shine_in_front) {
  const ScratchDirectory scratch;
  const std::string turns[2] = {R"(<rotate x="1" angle="-90"/><translate y="1"/>)",  // towards the camera
                                R"(<rotate x="1" angle="90"/><translate y="1"/>)"};
  for (const bool mesh : {false, true}) {
    const auto scene_of = [&](const std::string& turn, bool hide) {
      return parse(patch_under(mesh ? obj(write_square(scratch), turn) : rectangle(turn), hide));
    };
    const auto first_pixel = [&](const Scene& scene) {
      return render(scene, RayTracer(scene), small_settings("best", Choice::solid_angle), "").image.pixels[0];
    };
    EXPECT_NEAR(first_pixel(scene_of(turns[0], false)).y, 2, 1e-5);
    EXPECT_EQ(first_pixel(scene_of(turns[1], false)), Rgb(0.0f));
    EXPECT_EQ(first_pixel(scene_of(turns[0], true)), Rgb(0.0f));
    EXPECT_GT(first_pixel(scene_of(turns[1], true)).y, 0.1f);
  }
}

TEST(Compare, area_sampling_loses_next_to_a_rectangle) {
  const ScratchDirectory scratch;
  const Scene scene = read_scene(std::filesystem::path(WAVEFRONT_SCENES) / "spheres-rectangle.xml");
  Comparison comparison;
  for (const char* map : {"area", "spherical"}) comparison.samplings.push_back(light_sampling(map));
  comparison.reference_spp = 64;
  comparison.settings = {.width = 80, .height = 60, .spp = 9};
  comparison.out = scratch.path();
  testing::internal::CaptureStdout();
  compare(scene, comparison);
  testing::internal::GetCapturedStdout();
  const auto report = nlohmann::json::parse(std::ifstream(scratch.path() / "report.json"));
  EXPECT_GT(report["rows"][0]["mse"].get<double>(), 30 * report["rows"][1]["mse"].get<double>());
}

}  // namespace
}  // namespace wavefront
