#pragma once
/// \file
/// Scenes for the tests, written to files of their own.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "viz/render/scene/scene_reader.hpp"

namespace rayproof::render {

/// A folder that goes away with the test.
class SceneFiles : public testing::Test {
 protected:
  void SetUp() override {
    folder = std::filesystem::path(testing::TempDir()) / ("rayproof-scene-" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  /// Writes a file and gives back its path.
  [[nodiscard]] std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder / name, std::ios::binary) << text;
    return (folder / name).string();
  }
  [[nodiscard]] RenderScene scene(const std::string& text, const SceneOverrides& overrides = {}) const {
    return read_scene(write("scene.json", text), no_mesh, overrides);
  }

  static std::vector<Triangle<double>> no_mesh(const std::filesystem::path& file) {
    throw UnreadableFile("the file " + file.string() + " can't be read");
  }

  std::filesystem::path folder;
};

/// A scene of these shapes, each an entry of `shapes`.
inline std::string scene_text(const std::string& shapes, const std::string& size = "[40, 30]",
                              const std::string& more = R"("precision": "float32", )") {
  return R"({)" + more + R"("size": )" + size +
         R"(, "camera": {"eye": [0.5, 1, 6], "center": [0, 0, 0], "up": [0, 1, 0], "fov_x": 60, "fov_y": 45}, )" +
         R"("shapes": [)" + shapes + "]}";
}

inline const std::string sphere_entry = R"({"shape": {"type": "sphere", "center": [0, 0, 0], "radius": 1}})";

/// One of each shape and more, some of them transformed, overlapping in the image.
inline const std::string mixed_entries = R"(
 {"shape": {"type": "plane", "normal": [0, 1, 0], "d": 1}},
 {"shape": {"type": "plane", "point": [0, 0, -9], "u": [1, 0, 0], "v": [0, 1, 0.25]}},
 {"shape": {"type": "sphere", "center": [-1, 0, 0], "radius": 1}},
 {"shape": {"type": "sphere", "center": [0, 0, 0], "radius": 1}, "transform": [[0.5, 0.25, 0, 1], [0, 1.5, 0, 0], [0, 0, 0.5, 1], [0, 0, 0, 1]]},
 {"shape": {"type": "triangle", "a": [-2, -1, -3], "b": [2, -1, -2], "c": [0, 2.5, -3]}},
 {"shape": {"type": "polygon", "vertices": [[1, 0, -1], [3, 0, -1], [1.2, 1.5, -1], [2, -1, -1], [2.8, 1.5, -1]]}},
 {"shape": {"type": "box", "min": [-3, -1, -1], "max": [-2, 0.5, 1]}},
 {"shape": {"type": "parallelepiped", "corner": [0.5, -1, 1], "edges": [[1, 0, 0.25], [0.125, 0.75, 0], [0, 0.25, 1]]}},
 {"shape": {"type": "cylinder", "rx": 0.5, "ry": 0.25, "height": 1, "capped": true}, "transform": [[1, 0, 0, -0.5], [0, 0, 1, -1], [0, -1, 0, 2.5], [0, 0, 0, 1]]}
)";

/// This many small spheres in a grid, enough for a tree.
inline std::string many_spheres(int side) {
  std::string entries;
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < side; ++y) {
      entries += (entries.empty() ? "" : ", ") + std::string(R"({"shape": {"type": "sphere", "center": [)") +
                 std::to_string(x - side / 2) + "," + std::to_string(y - side / 2) + "," +
                 std::to_string((x * 7 + y * 5) % 4 - 6) + R"(], "radius": 0.625}})";
    }
  }
  return entries;
}

}  // namespace rayproof::render
