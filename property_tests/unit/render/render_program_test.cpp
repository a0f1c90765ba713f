#include <algorithm>

#include "unit/command.hpp"
#include "unit/render/scenes.hpp"

namespace rayproof::render {
namespace {

using test::Ended;
using test::run;

const std::string render = "env -u DISPLAY " RAYPROOF_BIN_DIR "/rayproof-render ";

class RenderProgram : public SceneFiles {
 protected:
  void SetUp() override {
    SceneFiles::SetUp();
    if (!std::filesystem::exists(RAYPROOF_BIN_DIR "/rayproof-render"))
      GTEST_SKIP() << "rayproof-render is not built";
  }
  [[nodiscard]] std::string out(const std::string& name) const { return (folder / name).string(); }
  /// How many files stand in the folder under names other than the scene's.
  [[nodiscard]] std::size_t count_files() const {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      count += entry.path().extension() != ".json";
    return count;
  }
  /// The width and height that a PNG's header names; 0 for no PNG.
  [[nodiscard]] static std::pair<unsigned, unsigned> png_size(const std::string& file) {
    std::array<unsigned char, 24> head{};
    std::ifstream(file, std::ios::binary).read(reinterpret_cast<char*>(head.data()), head.size());
    if (head[1] != 'P' || head[2] != 'N' || head[3] != 'G') return {};
    const auto number = [&head](std::size_t at) {
      return unsigned{head[at]} << 24U | unsigned{head[at + 1]} << 16U | unsigned{head[at + 2]} << 8U |
             head[at + 3];
    };
    return {number(16), number(20)};
  }
};

TEST_F(RenderProgram, WritesAPngOfTheScenesSizeWithoutADisplay) {
  const std::string scene = write("scene.json", scene_text(mixed_entries));
  for (const std::string how :
       {"", "--exact ", "--shade flat --precision float64 --jobs 2 --method sphere/textbook "}) {
    const Ended ended = run(render + scene + " " + how + "--out " + out("a.png"));
    EXPECT_EQ(ended.status, 0) << ended.output;
    EXPECT_EQ(png_size(out("a.png")), std::pair(40U, 30U));
  }
  EXPECT_EQ(run(render + scene + " --size 17x9 --out " + out("a.png")).status, 0);
  EXPECT_EQ(png_size(out("a.png")), std::pair(17U, 9U));
  EXPECT_EQ(count_files(), 1U);
}

TEST_F(RenderProgram, WritesToAPipe) {
  const std::string scene = write("scene.json", scene_text(sphere_entry));
  const Ended ended = run("cd " + folder.string() + " && mkfifo pipe && cat pipe > copy.png & sleep 0.3; " +
                          render + scene + " --size 5x5 --out " + out("pipe") + "; wait");
  EXPECT_EQ(ended.status, 0) << ended.output;
  EXPECT_EQ(png_size(out("copy.png")), std::pair(5U, 5U));
  EXPECT_TRUE(std::filesystem::is_fifo(out("pipe")));
}

TEST_F(RenderProgram, DrawsErrorsWithTheirTotals) {
  const std::string scene = write("scene.json", scene_text(mixed_entries));
  for (const std::string how :
       {"--error", "--error plane/printed_implicit", "--compare sphere/textbook sphere/centred"}) {
    const Ended ended = run(render + scene + " --out " + out("a.png") + " " + how);
    EXPECT_EQ(ended.status, 0) << ended.output;
    EXPECT_NE(ended.output.find("wrong hits"), std::string::npos) << ended.output;
    EXPECT_GT(png_size(out("a.png")).first, 400U);
  }
}

TEST_F(RenderProgram, TheSceneMayStandAnywhere) {
  const std::string scene = write("scene.json", scene_text(sphere_entry));
  const std::string png = "--out " + out("a.png");
  for (const std::string& command : {png + " --method sphere/textbook " + scene, png + " --error " + scene,
                                     "--error sphere/half_b " + scene + " " + png,
                                     "--compare sphere/half_b sphere/centred " + scene + " " + png}) {
    const Ended ended = run(render + command);
    EXPECT_EQ(ended.status, 0) << command << "\n" << ended.output;
  }
}

TEST_F(RenderProgram, APixelsCaseGoesToExplain) {
  const std::string scene = write("scene.json", scene_text(sphere_entry));
  const std::string explain = RAYPROOF_BIN_DIR "/rayproof-explain";
  const Ended ended = run(render + scene + " --case 18 16 | " + explain + " - --method sphere/textbook");
  EXPECT_EQ(ended.status, 0) << ended.output;
  EXPECT_EQ(ended.output.find("sphere/textbook"), 0U) << ended.output;
  EXPECT_EQ(run(render + scene + " --case 0 0").status, 2) << "nothing is there";
  EXPECT_EQ(run(render + scene + " --case 40 0").status, 2) << "outside";
}

TEST_F(RenderProgram, APixelsCaseBecomesAPageByTheMethodWhoseErrorsAreAsked) {
  const std::string scene = write("scene.json", scene_text(sphere_entry));
  const std::string page = out("pixel.html");
  const Ended ended = run(render + scene + " --error sphere/textbook --case 18 16 --out " + page);
  EXPECT_EQ(ended.status, 0) << ended.output;
  EXPECT_EQ(ended.output, run(render + scene + " --case 18 16 --method sphere/textbook").output);
  std::ifstream file(page, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_NE(text.find("sphere/textbook"), std::string::npos);
  EXPECT_NE(text.find("pixel (18, 16)"), std::string::npos);
}

TEST_F(RenderProgram, AWindowNeedsErrorsToShowAndADisplay) {
  const std::string scene = write("scene.json", scene_text(sphere_entry));
  for (const std::string how :
       {"--window", "--error --window", "--window --exact", "--error --window --case 18 16"}) {
    const Ended ended = run(render + scene + " " + how);
    EXPECT_EQ(ended.status, 2) << how << ended.output;
    EXPECT_EQ(std::count(ended.output.begin(), ended.output.end(), '\n'), 1) << ended.output;
  }
}

TEST_F(RenderProgram, ARefusedSceneEndsWith1AndAMissingFileWith2) {
  const std::string bad =
      write("bad.json", scene_text(R"({"shape": {"type": "sphere", "center": [0,0,0], "radius": -1}})"));
  const std::string mesh = write("mesh.json", scene_text(R"({"mesh": "gone.obj"})"));
  for (const auto& [scene, status] :
       {std::pair(bad, 1), std::pair(mesh, 2), std::pair(out("none.json"), 2)}) {
    const Ended ended = run(render + scene + " --out " + out("a.png"));
    EXPECT_EQ(ended.status, status) << ended.output;
    EXPECT_EQ(std::count(ended.output.begin(), ended.output.end(), '\n'), 1) << ended.output;
    EXPECT_EQ(ended.output.find("rayproof render: "), 0U) << ended.output;
  }
  EXPECT_EQ(count_files(), 0U) << "nothing is left behind";
}

TEST_F(RenderProgram, AWrongCommandLineEndsWith2AndOneSentence) {
  const std::string scene = write("scene.json", scene_text(sphere_entry));
  const std::string png = " --out " + out("a.png");
  for (const std::string& command :
       {scene, scene + png + " --method sphere/textbok", scene + png + " --method glm",
        scene + png + " --size 40", scene + png + " --size 0x3", scene + png + " --exact --error",
        scene + png + " --precision float16", scene + png + " --compare sphere/textbook",
        scene + png + " --jobs 0", scene + " --out " + out("a.jpg"), scene + png + " --method box/slabs",
        scene + png + " --error box/slabs", scene + " --out " + folder.string(),
        scene + " --out /no/such/folder/a.png", png, scene + png + " --error --size 9000x20"}) {
    const Ended ended = run(render + command);
    EXPECT_EQ(ended.status, 2) << command << "\n" << ended.output;
    EXPECT_EQ(std::count(ended.output.begin(), ended.output.end(), '\n'), 1) << ended.output;
  }
  EXPECT_EQ(count_files(), 0U);
}

TEST_F(RenderProgram, CtrlCLeavesNoFileAndEndsWith130) {
  const std::string scene = write("scene.json", scene_text(mixed_entries, "[8000, 6000]"));
  // In the foreground, or else timeout signals twice, and the second Ctrl-C is to end the program at once.
  const Ended ended = run("timeout --foreground --preserve-status -s INT 1 " + render + scene +
                          " --exact --out " + out("a.png"));
  EXPECT_EQ(ended.status, 130) << ended.output;
  EXPECT_EQ(count_files(), 0U);
}

}  // namespace
}  // namespace rayproof::render
