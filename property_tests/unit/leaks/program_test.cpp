/// \file
/// rayproof leak as somebody outside runs it.

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "unit/command.hpp"

namespace rayproof {
namespace {

/// The folder of the running test alone: tests run side by side.
std::string own_folder() {
  return testing::TempDir() + "leak-" + testing::UnitTest::GetInstance()->current_test_info()->name();
}

test::Ended leak(const std::string& options) {
  return test::run(std::string(RAYPROOF_BIN_DIR) + "/rayproof-leak --out " + own_folder() + " " + options);
}

TEST(LeakProgram, SaysThatSoundMethodsAreTight) {
  const test::Ended ended = leak("cube --rays 2000");
  EXPECT_EQ(ended.status, 0) << ended.output;
  EXPECT_NE(ended.output.find("no sound method leaks or hits twice"), std::string::npos) << ended.output;
}

/// A program of unit/guests on trial.
std::string guest(const std::string& words) {
  return "--subject-command 'python3 " RAYPROOF_SOURCE_DIR "/property_tests/unit/guests/" + words + "'";
}

TEST(LeakProgram, ShowsTheFirstLeakOfAProgramOnTrial) {
  const test::Ended ended = leak("torus --rays 2000 --precision float64 " + guest("right.py"));
  EXPECT_EQ(ended.status, 1) << ended.output;
  EXPECT_NE(ended.output.find("\ntriangle/command in float64: "), std::string::npos) << ended.output;
  EXPECT_NE(ended.output.find("NOT everybody on trial is tight"), std::string::npos) << ended.output;
  EXPECT_EQ(ended.output.find("triangle/woop"), std::string::npos) << "our methods are on trial where named";
  std::ifstream file(own_folder() + "/index.html");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  EXPECT_NE(page.find("triangle/command <span class=\"soft\">float64</span>: leak</h3>"), std::string::npos);
  EXPECT_NE(page.find("class=\"ray\""), std::string::npos);
}

TEST(LeakProgram, WritesTheFiguresOfMethodsAndProgramsAsJson) {
  const std::string file = own_folder() + ".json";
  const test::Ended ended =
      leak("cube --rays 200 --precision float32 --method woop " + guest("right.py") + " --json " + file);
  std::ifstream stream(file);
  const auto figures = nlohmann::json::parse(stream);
  ASSERT_EQ(figures["subjects"].size(), 2U) << ended.output;
  EXPECT_EQ(figures["subjects"][0]["subject"], "triangle/woop");
  EXPECT_EQ(figures["subjects"][0]["leaks"], 0);
  EXPECT_EQ(figures["subjects"][1]["subject"], "triangle/command");
  EXPECT_EQ(figures["subjects"][0]["rays"], figures["subjects"][1]["rays"]);
}

TEST(LeakProgram, SaysWhoGivesNoAnswer) {
  const test::Ended ended = leak("cube --rays 200 --subject-command false");
  EXPECT_EQ(ended.status, 1) << ended.output;
  EXPECT_NE(ended.output.find("rays without an answer"), std::string::npos) << ended.output;
}

TEST(LeakProgram, SaysWhereNothingWasJudged) {
  const std::string flat = own_folder() + ".off";
  std::ofstream(flat) << "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 2 1 0\n";
  const test::Ended ended = leak(flat + " --rays 1e2");
  EXPECT_EQ(ended.status, 2) << ended.output;
  EXPECT_NE(ended.output.find("rayproof leak: no ray was judged: the surface turns away"), std::string::npos);
}

TEST(LeakProgram, SaysThatAFileCannotBeWritten) {
  const test::Ended full = leak("cube --rays 100 --method woop --json /dev/full");
  EXPECT_EQ(full.status, 2);
  EXPECT_EQ(full.output, "rayproof leak: /dev/full cannot be written: is the disk full?\n");
}

TEST(LeakProgram, RefusesWhatItCannotUseWithOneSentence) {
  const test::Ended missing = leak("/nowhere.off");
  EXPECT_EQ(missing.status, 2);
  EXPECT_EQ(missing.output, "rayproof leak: /nowhere.off does not exist\n");
  const test::Ended unknown = leak("cube --method nobody");
  EXPECT_EQ(unknown.status, 2);
  EXPECT_TRUE(unknown.output.starts_with(
      "rayproof leak: there is no method \"nobody\" of triangles; there are cramer, "));
  const test::Ended stranger = leak("cube --subject nobody");
  EXPECT_EQ(stranger.status, 2);
  EXPECT_NE(stranger.output.find("rayproof leak: there is no subject \"nobody\""), std::string::npos);
  const test::Ended nothing = leak("cube --rays 100 --subject-command /nowhere");
  EXPECT_EQ(nothing.status, 2) << nothing.output;
  EXPECT_NE(nothing.output.find("/nowhere cannot be started"), std::string::npos) << nothing.output;
}

}  // namespace
}  // namespace rayproof
