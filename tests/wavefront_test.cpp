// The renderer in bench/wavefront: its reader, camera and sampler, and a small picture with a known answer.
#include "camera.h"
#include "compare.h"
#include "mesh.h"
#include "sampler.h"
#include "scene_reader.h"
#include "support/scene_text.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

namespace wavefront {
namespace {

const std::string light = R"(<shape type="disk">
  <transform name="toWorld"><scale value="2"/><rotate x="1" angle="90"/><translate x="1" y="3" z="-4"/></transform>
  <emitter type="area"><rgb name="radiance" value="1, 2, 3"/></emitter>
</shape>
)";

TEST(SceneReader, reads_the_spheres) {
  const Scene scene = read_scene(std::filesystem::path(WAVEFRONT_SCENES) / "spheres.xml");
  EXPECT_EQ(scene.shapes.size(), 5u);
  ASSERT_EQ(scene.emitters.size(), 1u);
  EXPECT_TRUE(scene.hide_emitters);
  EXPECT_TRUE(scene.ignored.empty());
  EXPECT_EQ(scene.width, 640);
  EXPECT_EQ(scene.height, 480);
  const Emitter& emitter = scene.emitters[0];
  EXPECT_TRUE(emitter.double_sided);
  const auto& disk = std::get<hatbox::Disk>(emitter.light);
  expect_near(to_v3f(disk.center), {1, 3, 4}, 1e-6f);
  EXPECT_NEAR(std::abs(disk.normal.z), 1, 1e-6);
  EXPECT_FLOAT_EQ(disk.radius, 3);
  const auto& ground = std::get<Mesh>(scene.shapes[0].geometry);
  expect_near(ground.normals[0], {0, 1, 0}, 1e-6f);
  EXPECT_EQ(scene.shapes[0].reflectance, Rgb(0.7f));
}

TEST(SceneReader, applies_transforms_in_the_order_written) {
  const Scene scene = parse(sensor + light);
  const auto& disk = std::get<hatbox::Disk>(scene.emitters.at(0).light);
  expect_near(to_v3f(disk.center), {1, 3, -4}, 1e-6f);
  expect_near(to_v3f(disk.normal), {0, -1, 0}, 1e-6f);
  EXPECT_FLOAT_EQ(disk.radius, 2);
  EXPECT_EQ(scene.emitters[0].radiance, Rgb(1, 2, 3));
  EXPECT_FALSE(scene.emitters[0].double_sided);
}

TEST(SceneReader, reads_a_matrix_by_rows) {
  const Scene scene = parse(sensor + light + R"(<shape type="sphere"><transform name="toWorld">
    <matrix value="0 -2 0 5, 2 0 0 6, 0 0 2 7, 0 0 0 1"/></transform><point name="center" x="1"/></shape>)");
  const auto& sphere = std::get<Sphere>(scene.shapes[1].geometry);
  expect_near(sphere.center, {5, 8, 7}, 1e-6f);
  EXPECT_FLOAT_EQ(sphere.radius, 2);
}

TEST(SceneReader, names_the_unknown_element_and_its_line) {
  const std::string error = error_of(sensor + light + "\n\n<texture type=\"bitmap\"/>");
  EXPECT_NE(error.find("texture"), error.npos) << error;
  EXPECT_NE(error.find("test.xml:12:"), error.npos) << error;
  EXPECT_EQ(error.find('\n'), error.npos) << error;
}

TEST(SceneReader, refuses_what_it_would_get_wrong) {
  EXPECT_NE(error_of(sensor + "<shape type=\"cylinder\"/>").find("'cylinder'"), std::string::npos);
  EXPECT_NE(error_of(sensor + "<shape type=\"sphere\"><ref id=\"x\"/></shape>").find("'x'"), std::string::npos);
  EXPECT_NE(error_of(sensor + "<shape type=\"sphere\"><float name=\"radius\" value=\"two\"/></shape>").find("'two'"),
            std::string::npos);
  EXPECT_NE(error_of(sensor + "<shape type=\"sphere\"><transform name=\"toWorld\"><scale x=\"2\"/></transform></shape>")
                .find("ellipsoid"),
            std::string::npos);
  EXPECT_NE(
      error_of(sensor + "<shape type=\"obj\"><string name=\"filename\" value=\"no.obj\"/></shape>").find("no.obj"),
      std::string::npos);
  EXPECT_NE(error_of(sensor).find("light"), std::string::npos);
  EXPECT_NE(error_of(light).find("sensor"), std::string::npos);
  EXPECT_NE(error_of("<shape>").find("test.xml:2"), std::string::npos);
}

TEST(SceneReader, lists_the_properties_it_ignores) {
  const Scene scene = parse(sensor + light + "<shape type=\"sphere\"><string name=\"sampling\" value=\"?\"/></shape>");
  EXPECT_EQ(scene.ignored, std::vector<std::string>{"shape sampling (line 10)"});
}

TEST(Mesh, reads_obj_and_averages_normals) {
  const ScratchDirectory scratch;
  const auto path = scratch.path() / "roof.obj";
  std::ofstream(path) << "v 0 0 0\nv 0 0 1\nv 1 1 0\nv 1 1 1\nv 2 0 0\nv 2 0 1\nf 1 2 4 3\nf 3 4 6 5\n";
  const Mesh mesh = load_obj(path, Imath::M44d(), false);
  EXPECT_EQ(mesh.triangles.size(), 4u);
  ASSERT_EQ(mesh.positions.size(), 6u);
  expect_near(mesh.normals[0], V3f(-1, 1, 0).normalized(), 1e-6f);
  EXPECT_TRUE(load_obj(path, Imath::M44d(), true).normals.empty());
}

TEST(Camera, sees_the_right_hand_side_on_the_right) {
  const Scene scene = parse(sensor + light);  // looks along -z, 90 degrees wide
  const Camera camera(scene.view, 200, 100);
  expect_near(camera.origin(), {0, 0, 0}, 1e-6f);
  expect_near(camera.direction(100, 50), {0, 0, -1}, 1e-6f);
  expect_near(camera.direction(200, 50), V3f(1, 0, -1).normalized(), 1e-6f);
  expect_near(camera.direction(0, 50), V3f(-1, 0, -1).normalized(), 1e-6f);
  expect_near(camera.direction(100, 0), V3f(0, 0.5f, -1).normalized(), 1e-6f);
}

/// Every box of area 2^-m whose sides are powers of two holds one of the 2^m points from `first`.
void expect_net(const Sampler& sampler, std::uint64_t key, std::uint32_t first, int m) {
  for (int i = 0; i <= m; ++i) {
    std::set<std::pair<int, int>> boxes;
    for (std::uint32_t index = first; index < first + (1u << m); ++index) {
      const Sample2 sample = sampler(key, index);
      boxes.insert({static_cast<int>(std::ldexp(sample.x, i)), static_cast<int>(std::ldexp(sample.y, m - i))});
    }
    EXPECT_EQ(boxes.size(), std::size_t{1} << m) << "m = " << m << ", i = " << i;
  }
}

TEST(Sampler, zero_two_blocks_are_nets) {
  const Sampler sampler(SamplerKind::zero_two, 1024);
  for (const std::uint64_t key : {std::uint64_t{0}, hash(1, 2), hash(3, 4)})
    for (int m = 0; m <= 8; ++m)
      for (std::uint32_t block = 0; block < 4; ++block) expect_net(sampler, key, block << m, m);
}

TEST(Sampler, is_uniform_over_keys) {
  for (const auto kind : {SamplerKind::zero_two, SamplerKind::random}) {
    const Sampler sampler(kind, 8);
    double mean_x = 0, mean_y = 0, mean_xy = 0;
    constexpr int keys = 100000;
    for (std::uint64_t key = 0; key < keys; ++key) {
      const Sample2 sample = sampler(hash(7, key), 5);
      ASSERT_TRUE(sample.x >= 0 && sample.x < 1 && sample.y >= 0 && sample.y < 1);
      mean_x += sample.x / keys;
      mean_y += sample.y / keys;
      mean_xy += sample.x * sample.y / keys;
    }
    EXPECT_NEAR(mean_x, 0.5, 0.005);
    EXPECT_NEAR(mean_y, 0.5, 0.005);
    EXPECT_NEAR(mean_xy, 0.25, 0.005);
  }
}

TEST(Sampler, shuffles_within_aligned_blocks) {
  for (std::uint64_t key = 0; key < 16; ++key) {
    std::set<std::uint32_t> all;
    for (std::uint32_t index = 0; index < 32; ++index) {
      const std::uint32_t shuffled = shuffle_index(index, 5, hash(key, 0));
      all.insert(shuffled);
      EXPECT_EQ(shuffled / 4, shuffle_index(index ^ 3, 5, hash(key, 0)) / 4);
    }
    EXPECT_EQ(all.size(), 32u);
    EXPECT_EQ(*all.rbegin(), 31u);
  }
}

/// A patch under the middle of a light that faces it, both perpendicular to the axis: irradiance π L r² / (r² + h²).
const std::string patch_under_light = patch_under(R"(<shape type="disk">
  <transform name="toWorld"><scale value="2"/><rotate x="1" angle="90"/><translate y="1.5"/></transform>
  <emitter type="area"><rgb name="radiance" value="1, 2, 3"/></emitter>
</shape>
)",
                                                  true);

RenderSettings small_settings(const char* map) {
  return {.width = 5, .height = 3, .spp = 16, .light_samples = 64, .sampling = light_sampling(map)};
}

TEST(Render, converges_to_the_known_irradiance) {
  const Scene scene = parse(patch_under_light);
  const RayTracer tracer(scene);
  const float expected = 0.5f * 4 / (4 + 2.25f);
  for (const char* map : {"area", "ld_radial", "radial", "table", "auto"}) {
    const Render result = render(scene, tracer, small_settings(map), "");
    EXPECT_EQ(result.light_samples, 5u * 3 * 16 * 64);
    for (const Rgb& pixel : result.image.pixels) {
      EXPECT_NEAR(pixel.x, expected, 2e-3);
      EXPECT_NEAR(pixel.z, 3 * expected, 6e-3);
    }
  }
}

TEST(Render, light_that_faces_away_gives_none) {
  std::string body = patch_under_light;
  body.replace(body.find("angle=\"90\""), 10, "angle=\"270\"");
  const Scene scene = parse(body);
  const Render result = render(scene, RayTracer(scene), small_settings("ld_radial"), "");
  for (const Rgb& pixel : result.image.pixels) EXPECT_EQ(pixel, Rgb(0.0f));
}

TEST(Render, shows_the_light_and_its_shadow_unless_hidden) {
  std::string body = patch_under_light;
  body.replace(body.find("value=\"true\""), 12, "value=\"false\"");
  body.replace(body.find("angle=\"90\""), 10, "angle=\"270\"");
  const Scene scene = parse(body);  // the camera above now looks at the shining side
  const Render result = render(scene, RayTracer(scene), small_settings("ld_radial"), "");
  for (const Rgb& pixel : result.image.pixels) EXPECT_NEAR(pixel.y, 2, 1e-5);
}

TEST(Render, does_not_depend_on_the_split_into_chunks) {
  const Scene scene = parse(patch_under_light);
  const RayTracer tracer(scene);
  RenderSettings settings = small_settings("ld_radial");
  settings.width = 8;
  settings.height = 2;
  const Image wide = render(scene, tracer, settings, "").image;
  settings.light_samples = 1 << 14;  // fewer pixels at a time than the picture has
  const Image accurate = render(scene, tracer, settings, "").image;
  EXPECT_LT(mean_squared_error(wide, accurate), 1e-6);
}

TEST(Compare, writes_pictures_and_the_report) {
  const ScratchDirectory scratch;
  const Scene scene = read_scene(std::filesystem::path(WAVEFRONT_SCENES) / "spheres.xml");
  Comparison comparison;
  comparison.scene_name = "spheres";
  for (const char* map : {"area", "ld_radial", "radial"}) comparison.samplings.push_back(light_sampling(map));
  comparison.reference_spp = 128;
  comparison.settings = {.width = 80, .height = 60, .spp = 16};
  comparison.out = scratch.path();
  testing::internal::CaptureStdout();
  compare(scene, comparison);
  EXPECT_NE(testing::internal::GetCapturedStdout().find("ld_radial"), std::string::npos);
  for (const char* file : {"area.exr", "area.png", "ld_radial_error.png", "reference.exr", "comparison.png"})
    EXPECT_TRUE(std::filesystem::exists(scratch.path() / file)) << file;

  const auto report = nlohmann::json::parse(std::ifstream(scratch.path() / "report.json"));
  EXPECT_EQ(report["scene"], "spheres");
  ASSERT_EQ(report["rows"].size(), 3u);
  for (const auto& row : report["rows"]) {
    EXPECT_EQ(row["spp"], 16);
    EXPECT_GT(row["ns_per_light_sample"], 0.0);
    EXPECT_GT(row["seconds"], 0.0);
    EXPECT_GT(row["light_stage_share"], 0.0);
    EXPECT_LT(row["light_stage_share"], 1.0);
  }
  // The paper's Figure 7 at an eighth of its size: area sampling must lose by more than a hundred to one.
  const auto mse = [&](int row) { return report["rows"][static_cast<std::size_t>(row)]["mse"].get<double>(); };
  EXPECT_GT(mse(0), 100 * mse(1));
  EXPECT_GT(mse(0), 100 * mse(2));
  EXPECT_LT(report["reference"]["mse"].get<double>(), 0.2 * std::min(mse(1), mse(2)));
}

TEST(Compare, names_the_maps_there_are) {
  EXPECT_EQ(light_sampling("area").name, "area");
  EXPECT_THROW(light_sampling("square"), std::invalid_argument);
}

}  // namespace
}  // namespace wavefront
