#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "unit/command.hpp"
#include "unit/viz/player/player.hpp"
#include "unit/vtk/x_client.hpp"
#include "viz/vtk/offscreen_display.hpp"

namespace rayproof::viz {
namespace {

const std::string walk_for_a_minute = "timeout 60 " RAYPROOF_BIN_DIR "/rayproof-walk ";

using test::Ended;
using test::Running;

TEST(WindowProgram, NoDisplayIsOneSentenceAndStatus2) {
  for (const std::string& display : {std::string("-u DISPLAY "), std::string("DISPLAY= "),
                                     std::string("DISPLAY=:31999 "), std::string("DISPLAY=nonsense ")}) {
    Running program("env " + display + walk_for_a_minute + "sphere --window");
    const auto [status, output] = program.wait();
    EXPECT_EQ(status, 2) << display << output;
    EXPECT_EQ(std::count(output.begin(), output.end(), '\n'), 1) << output;
    EXPECT_NE(output.find("isplay"), std::string::npos) << output;
  }
}

TEST(WindowProgram, AWrongTopicOrCaseIsReportedBeforeAnyWindow) {
  Running topic("env -u DISPLAY " + walk_for_a_minute + "no-such-topic --window");
  const Ended unknown = topic.wait();
  EXPECT_NE(unknown.output.find("no-such-topic"), std::string::npos);
  EXPECT_EQ(unknown.status, 2);
  Running refused("env -u DISPLAY " + walk_for_a_minute +
                  R"(--window --case '{"query":"quadratic","a":1,"b":2}')");
  EXPECT_EQ(refused.wait().status, 1);
}

TEST(WindowProgram, ItRunsUntilQAndPrintsTheCaseThatWasDragged) {
  const OffscreenDisplay display("1280x900x24");
  Running program(walk_for_a_minute + "--window --method sphere/centred --case '" + sphere_case + "'");
  XClient user;
  ASSERT_TRUE(user.find_window());
  // Four Tabs put the arrow keys on the arrow's tip.
  for (const char* key : {"Tab", "Tab", "Tab", "Tab", "Up", "c", "q"}) user.press_key(key);
  const auto [status, output] = program.wait();
  EXPECT_EQ(status, 0) << output;
  ASSERT_EQ(std::count(output.begin(), output.end(), '\n'), 1) << output;
  const Case moved = read_case(output.substr(0, output.size() - 1));
  const auto ray = [](const Case& one) { return std::get<RayQuestion>(one.question).ray; };
  EXPECT_EQ(ray(moved).origin, ray(read_case(sphere_case)).origin);
  EXPECT_NE(ray(moved).direction, ray(read_case(sphere_case)).direction);
}

TEST(WindowProgram, SSavesThePictureWhereItMayAndSaysSoWhereItMayNot) {
  const OffscreenDisplay display("1280x900x24");
  const std::filesystem::path here = testing::TempDir() + "saved-pictures";
  std::filesystem::create_directory(here);
  const std::filesystem::path picture = here / "ray-2-window.png";
  std::filesystem::remove(picture);
  const auto save = [&] {
    Running program("cd " + here.string() + " && " + walk_for_a_minute + "ray --window 2>&1");
    XClient user;
    EXPECT_TRUE(user.find_window());
    for (const char* key : {"Right", "s", "q"}) user.press_key(key);
    return program.wait();
  };
  const Ended saved = save();
  EXPECT_EQ(saved.status, 0) << saved.output;
  EXPECT_EQ(saved.output, "saved ray-2-window.png\n");
  EXPECT_GT(std::filesystem::file_size(picture), 10000U);

  std::filesystem::remove(picture);
  std::filesystem::create_directory(picture);  // which no file can be written to
  const Ended refused = save();
  EXPECT_EQ(refused.status, 0) << refused.output;
  EXPECT_EQ(refused.output, "rayproof walk: ray-2-window.png cannot be written\n");
  std::filesystem::remove_all(here);
}

TEST(WindowProgram, AClickOnAPixelOfAnErrorImagePrintsItsCaseAndWritesItsPage) {
  if (!std::filesystem::exists(RAYPROOF_BIN_DIR "/rayproof-render")) GTEST_SKIP() << "render is not built";
  const OffscreenDisplay display("2600x2200x24");  // the whole figure, pixel by pixel
  const std::filesystem::path here = testing::TempDir() + "clicked-pixels";
  std::filesystem::create_directory(here);
  Running program("cd " + here.string() +
                  " && timeout 60 " RAYPROOF_BIN_DIR "/rayproof-render " RAYPROOF_SOURCE_DIR
                  "/docs/scenes/far-sphere.json --size 32x24 --error sphere/textbook --window 2>/dev/null");
  XClient user;
  ASSERT_TRUE(user.find_window());
  user.press_button(470, 470);  // near the middle of the panel
  user.release_button(470, 470);
  user.press_key("q");
  const auto [status, output] = program.wait();
  EXPECT_EQ(status, 0) << output;
  ASSERT_EQ(std::count(output.begin(), output.end(), '\n'), 1) << output;
  const Case one = read_case(output.substr(0, output.size() - 1));
  const std::size_t at = one.note.find("pixel (");
  ASSERT_EQ(at, 0U) << one.note;
  int x = 0, y = 0;
  ASSERT_EQ(std::sscanf(one.note.c_str(), "pixel (%d, %d)", &x, &y), 2);
  EXPECT_NEAR(x, 16, 2);
  EXPECT_NEAR(y, 12, 2);
  const auto page = here / ("far-sphere-" + std::to_string(x) + "-" + std::to_string(y) + ".html");
  EXPECT_GT(std::filesystem::file_size(page), 100000U);
  std::filesystem::remove_all(here);
}

}  // namespace
}  // namespace rayproof::viz
