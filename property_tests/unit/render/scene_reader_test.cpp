#include "viz/render/scene/scene_reader.hpp"

#include <algorithm>
#include <array>

#include "case/shape_format.hpp"
#include "unit/render/scenes.hpp"

namespace rayproof::render {
namespace {

class SceneReader : public SceneFiles {};

TEST_F(SceneReader, ReadsWhatTheFileSays) {
  const RenderScene read = scene(scene_text(mixed_entries));
  EXPECT_EQ(read.precision, Precision::float32);
  EXPECT_EQ(read.width, 40);
  EXPECT_EQ(read.height, 30);
  EXPECT_EQ(read.camera.eye, glm::dvec3(0.5, 1, 6));
  EXPECT_EQ(read.camera.half_height, static_cast<double>(static_cast<float>(half_extent(45))));
  ASSERT_EQ(read.objects.size(), 9U);
  EXPECT_EQ(std::get<Sphere<double>>(read.objects[2].shape).center, glm::dvec3(-1, 0, 0));
  EXPECT_FALSE(read.objects[2].transform);
  EXPECT_EQ((*read.objects[3].transform)[1][0], 0.25);
  EXPECT_EQ(read.objects[8].entry, 8U);
}

TEST_F(SceneReader, RoundsEveryNumberToThePrecision) {
  const std::string tenth = R"({"shape": {"type": "sphere", "center": [0, 0, 0], "radius": 0.1}})";
  const auto radius = [](const RenderScene& s) {
    return std::get<Sphere<double>>(s.objects[0].shape).radius;
  };
  EXPECT_EQ(radius(scene(scene_text(tenth))), static_cast<double>(0.1F));
  EXPECT_EQ(radius(scene(scene_text(tenth), {Precision::float64, {}})), 0.1);
  EXPECT_EQ(radius(scene(scene_text(tenth, "[4, 3]", ""))), 0.1) << "float64 where the scene says nothing";
}

TEST_F(SceneReader, TakesThePrecisionAndSizeOfTheCommandLine) {
  const RenderScene read = scene(scene_text(sphere_entry), {Precision::float64, std::pair(7, 5)});
  EXPECT_EQ(read.precision, Precision::float64);
  EXPECT_EQ(read.width, 7);
  EXPECT_EQ(read.height, 5);
}

TEST_F(SceneReader, GivesTheTrianglesOfAMeshOneEntryAndItsTransform) {
  std::filesystem::path asked;
  const ReadMesh two = [&](const std::filesystem::path& file) {
    asked = file;
    return std::vector<Triangle<double>>{{{0.1, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                                         {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}};
  };
  const std::string file =
      write("scene.json",
            scene_text(sphere_entry +
                       R"(, {"mesh": "a/b.obj", "transform": [[2,0,0,0],[0,2,0,0],[0,0,2,0],[0,0,0,1]]})"));
  const RenderScene read = read_scene(file, two);
  EXPECT_EQ(asked, folder / "a/b.obj");
  ASSERT_EQ(read.objects.size(), 3U);
  for (const std::size_t i : {1U, 2U}) {
    EXPECT_EQ(read.objects[i].entry, 1U);
    EXPECT_EQ((*read.objects[i].transform)[0][0], 2);
  }
  EXPECT_EQ(std::get<Triangle<double>>(read.objects[1].shape).a.x, static_cast<double>(0.1F));
}

struct BadScene {
  const char* why;
  std::string text;
  const char* field;     ///< the refusal's
  const char* sentence;  ///< part of it
};

std::string with_entry(const std::string& entry) { return scene_text(sphere_entry + ", " + entry); }
std::string with_camera(const std::string& camera) {
  return R"({"size": [4, 3], "camera": )" + camera + R"(, "shapes": []})";
}

const std::array<BadScene, 21> bad_scenes{{
    {"not JSON", "{\"size\": [4, 3],", "line", "scene.json: the scene is not JSON"},
    {"not an object", "[]", "", "the scene must be a JSON object"},
    {"no camera", R"({"size": [4, 3], "shapes": []})", "camera", "camera is missing"},
    {"an unknown field",
     R"({"size": [4, 3], "lights": [], "camera": {"eye": [0,0,1], "center": [0,0,0], "up": [0,1,0], "fov_x": 60, "fov_y": 45}, "shapes": []})",
     "", "the scene has an unknown field \"lights\""},
    {"an unknown field of an entry",
     with_entry(R"({"shape": {"type": "sphere", "center": [0,0,0], "radius": 1}, "colour": "red"})"),
     "shapes[1]", "shapes[1] has an unknown field \"colour\""},
    {"an unknown field of a shape",
     with_entry(R"({"shape": {"type": "sphere", "center": [0,0,0], "radius": 1, "r": 2}})"),
     "shapes[1].shape", "shapes[1].shape has an unknown field \"r\""},
    {"an unknown shape", with_entry(R"({"shape": {"type": "spere"}})"), "shapes[1].shape.type",
     "unknown shape type, \"spere\""},
    {"neither shape nor mesh", with_entry("{}"), "shapes[1].shape", "shapes[1].shape is missing"},
    {"a negative radius", with_entry(R"({"shape": {"type": "sphere", "center": [0,0,0], "radius": -1}})"),
     "shapes[1].shape.radius", "radius must not be negative (here: -1)"},
    {"a number that is none",
     with_entry(R"({"shape": {"type": "sphere", "center": [0,"x",0], "radius": 1}})"),
     "shapes[1].shape.center[1]", "(here: \"x\")"},
    {"a number too large for float32",
     with_entry(R"({"shape": {"type": "sphere", "center": [0,1e39,0], "radius": 1}})"),
     "shapes[1].shape.center[1]", "must be finite as a float32 (here: 1e39)"},
    {"a singular matrix",
     with_entry(
         R"({"shape": {"type": "sphere", "center": [0,0,0], "radius": 1}, "transform": [[1,2,0,0],[2,4,0,0],[0,0,1,0],[0,0,0,1]]})"),
     "shapes[1].transform", "must not be singular (here: [[1,2,0,0],"},
    {"a matrix that is not affine",
     with_entry(
         R"({"shape": {"type": "sphere", "center": [0,0,0], "radius": 1}, "transform": [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,1,1]]})"),
     "shapes[1].transform", "must be affine"},
    {"a size of nothing", scene_text("", "[0, 3]"), "size[0]",
     "size[0] must be a whole number of pixels from 1 to 16384 (here: 0)"},
    {"a huge size", scene_text("", "[4, 1e9]"), "size[1]", "(here: 1e9)"},
    {"half a pixel", scene_text("", "[4.5, 3]"), "size[0]", "(here: 4.5)"},
    {"an angle of 180 degrees",
     with_camera(R"({"eye": [0,0,1], "center": [0,0,0], "up": [0,1,0], "fov_x": 180, "fov_y": 45})"),
     "camera.fov_x", "less than 180 degrees (here: 180)"},
    {"an eye at the centre",
     with_camera(R"({"eye": [0,0,1], "center": [0,0,1], "up": [0,1,0], "fov_x": 60, "fov_y": 45})"),
     "camera.center", "must not be the camera's eye (here: [0,0,1])"},
    {"up along the view",
     with_camera(R"({"eye": [0,0,1], "center": [0,0,0], "up": [0,0,2], "fov_x": 60, "fov_y": 45})"),
     "camera.up", "must not point along the camera's view"},
    {"a camera whose squares overflow in float32",
     R"({"precision": "float32", "size": [4, 3], "camera": {"eye": [0,0,1e25], "center": [0,0,0], "up": [0,1,0], "fov_x": 60, "fov_y": 45}, "shapes": []})",
     "camera", "camera has numbers too large"},
    {"an up that is along the view once rounded",
     R"({"precision": "float32", "size": [4, 3], "camera": {"eye": [0,0,1], "center": [0,0,0], "up": [1e-30,0,1], "fov_x": 60, "fov_y": 45}, "shapes": []})",
     "camera", "too nearly along a line"},
}};

TEST_F(SceneReader, RefusesABadSceneByFileFieldAndValue) {
  for (const BadScene& bad : bad_scenes) {
    try {
      static_cast<void>(scene(bad.text));
      ADD_FAILURE() << bad.why << " was taken";
    } catch (const Refusal& why) {
      const std::string sentence = why.what();
      EXPECT_EQ(why.field(), bad.field) << bad.why;
      EXPECT_NE(sentence.find("scene.json: "), std::string::npos) << sentence;
      EXPECT_NE(sentence.find(bad.sentence), std::string::npos) << sentence;
      EXPECT_EQ(std::count(sentence.begin(), sentence.end(), '\n'), 0) << sentence;
    }
  }
}

TEST_F(SceneReader, AMissingFileIsNamed) {
  const std::string mesh = write("scene.json", scene_text(R"({"mesh": "gone.obj"})"));
  for (const std::string& file : {(folder / "none.json").string(), folder.string(), mesh}) {
    try {
      static_cast<void>(read_scene(file, no_mesh));
      ADD_FAILURE() << file;
    } catch (const UnreadableFile& why) {
      EXPECT_NE(std::string(why.what()).find(file == mesh ? "gone.obj" : file), std::string::npos)
          << why.what();
    }
  }
}

TEST_F(SceneReader, AMeshBeyondThePrecisionIsRefused) {
  const ReadMesh far = [](const std::filesystem::path&) {
    return std::vector<Triangle<double>>{{{1e39, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  };
  const std::string file = write("scene.json", scene_text(R"({"mesh": "far.obj"})"));
  EXPECT_THROW(static_cast<void>(read_scene(file, far)), Refusal);
}

}  // namespace
}  // namespace rayproof::render
