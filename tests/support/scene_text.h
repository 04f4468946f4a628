// What the tests of the renderer share: scenes as text, and a directory for files.
#pragma once

#include "scene_reader.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace wavefront {

inline const std::string sensor = R"(<sensor type="perspective">
  <transform name="toWorld"><lookAt origin="0 0 0" target="0, 0, -5" up="0, 1, 0"/></transform>
  <float name="fov" value="90"/>
</sensor>
)";

inline Scene parse(const std::string& body) {
  return parse_scene("<scene version=\"0.5.0\">\n" + body + "</scene>", "test.xml");
}

/// What the reader says is wrong; empty if nothing.
inline std::string error_of(const std::string& body) {
  try {
    parse(body);
    return "";
  } catch (const SceneError& error) {
    return error.what();
  }
}

inline void expect_near(const V3f& a, const V3f& b, float tolerance) {
  EXPECT_LT((a - b).length(), tolerance) << a << " instead of " << b;
}

/// A patch of reflectance ½ at the origin under a light, seen from above it.
inline std::string patch_under(const std::string& shape, bool hide) {
  return std::string(R"(<integrator type="direct"><boolean name="hideEmitters" value=")") + (hide ? "true" : "false") +
         R"("/></integrator>
<sensor type="perspective">
  <transform name="toWorld"><lookAt origin="0, 5, 0" target="0, 0, 0" up="0, 0, 1"/></transform>
  <float name="fov" value="0.1"/>
</sensor>
<shape type="rectangle">
  <transform name="toWorld"><rotate x="1" angle="-90"/></transform>
  <bsdf type="diffuse"><spectrum name="reflectance" value="0.5"/></bsdf>
</shape>
)" + shape;
}

/// A directory that is gone after the test.
class ScratchDirectory {
 public:
  ScratchDirectory() : path_(std::filesystem::path(testing::TempDir()) / unique_name()) {
    std::filesystem::create_directories(path_);
  }
  ~ScratchDirectory() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchDirectory(const ScratchDirectory&) = delete;
  ScratchDirectory& operator=(const ScratchDirectory&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  static std::string unique_name() {
    return std::string("hatbox_") + testing::UnitTest::GetInstance()->current_test_info()->name();
  }
  std::filesystem::path path_;
};

}  // namespace wavefront
