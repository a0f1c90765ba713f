/// \file
/// An option that would change nothing is refused by its name, with status 2 and one sentence.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "unit/programs/program_run.hpp"

namespace rayproof {
namespace {

constexpr auto one_case =
    R"({"ray": {"origin": [0,0,-5], "direction": [0,0,1]}, "shape": {"type": "sphere", "center": [0,0,0], "radius": 1}})";

/// The program ends so and names `option`; one that was not built is left out.
void expect_idle(const std::string& command, const std::string& option) {
  const std::string program = RAYPROOF_BIN_DIR "/rayproof-" + command.substr(0, command.find(' '));
  if (!std::filesystem::exists(program)) return;
  const test::Ended ended = test::run_program(command);
  EXPECT_EQ(ended.status, 2) << command;
  EXPECT_NE(ended.output.find("leave " + option + " out"), std::string::npos) << command << ended.output;
  EXPECT_EQ(std::count(ended.output.begin(), ended.output.end(), '\n'), 1) << ended.output;
}

TEST(IdleOptions, OfCheckAreRefusedByName) {
  for (const std::string option :
       {"--shape plane", "--method plane/implicit", "--property verdict", "--family random",
        "--precision float32", "--seed 1", "--cases 3", "--time 1s", "--jobs 1", "--corpus f", "--out f",
        "--measure", "--labels", "--case-seconds 1"})
    expect_idle("check --replay /dev/null " + option, option.substr(0, option.find(' ')));
  expect_idle("check --campaign --corpus f", "--corpus");
  expect_idle("check --campaign --labels", "--labels");
  expect_idle("check --subject-command cat --labels", "--labels");
  expect_idle("check --subject-command cat --measure", "--measure");
  expect_idle("check --case-seconds 3", "--case-seconds");
}

TEST(IdleOptions, OfOtherProgramsAreRefusedByName) {
  for (const std::string option : {"--count 3", "--seed 1", "--precision float32"})
    expect_idle("cases --list " + option, option.substr(0, option.find(' ')));
  expect_idle("leak cube --case-seconds 3", "--case-seconds");
  expect_idle("replay /dev/null --from f", "--from");
  expect_idle("findings --from f --cases 3", "--cases");
  expect_idle("findings --from f --shape plane", "--shape");
  expect_idle("worst --time 1s --cases 3", "--cases");
  for (const std::string option : {"--shape plane", "--method vtk", "--family random", "--precision float32",
                                   "--rays 64", "--time 1", "--quick", "--scaling scenes"})
    expect_idle("report --figures /dev/null " + option, option.substr(0, option.find(' ')));
}

TEST(IdleOptions, OfWhatShowsACaseAreRefusedByName) {
  const std::string given = " '" + std::string(one_case) + "'";
  expect_idle("explain" + given + " --method sphere/textbook --line 1", "--line");
  expect_idle("explain" + given + " --method sphere/textbook --from f", "--from");
  expect_idle("explain 3 --line 2", "--line");
  expect_idle("draw" + given + " --svg a.svg --line 1", "--line");
  expect_idle("walk sphere --html a.html --from f", "--from");
  expect_idle("walk --list --json", "--json");
  expect_idle("walk sphere --list", "TOPIC");
}

TEST(IdleOptions, AreNoneWhereTheyChangeSomething) {
  const std::string file = testing::TempDir() + "rayproof_idle_" + std::to_string(::getpid()) + ".jsonl";
  std::ofstream(file) << one_case << "\n" << one_case << "\n";
  for (const std::string& command : {"explain " + file + " --method sphere/textbook --line 2",
                                     std::string("cases --list --shape plane"), "check --replay " + file})
    EXPECT_EQ(test::run_program(command).status, 0) << command;
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace rayproof
