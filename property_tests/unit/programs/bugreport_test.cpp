/// \file
/// rayproof bugreport where there is nobody to report to.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "unit/command.hpp"

namespace rayproof {
namespace {

TEST(BugreportProgram, FilesNothingOfAProgramWhoseMakersItDoesNotKnow) {
  const std::string file = testing::TempDir() + "rayproof_bugreport_" + std::to_string(::getpid());
  std::ofstream(file)
      << R"({"subject": "sphere/command", "shape": "sphere", "method": "command", "property": "verdict", )"
      << R"("kind": "gross", "case": {"ray": {"origin": [0,0,-5], "direction": [0,0,1]}, )"
      << R"("shape": {"type": "sphere", "center": [0,0,0], "radius": 1}}, "got": {"verdict": "miss"}, )"
      << R"("command": "cat"})"
      << "\n";
  const test::Ended ended = test::run(RAYPROOF_BIN_DIR "/rayproof-bugreport 1 --from " + file);
  EXPECT_EQ(ended.status, 1);
  EXPECT_EQ(
      ended.output,
      "rayproof bugreport: nothing to file: finding 1 is of a --subject-command, whose makers you know; "
      "rayproof explain and draw show it\n");
  std::filesystem::remove(file);
}

TEST(BugreportProgram, FilesNothingOfTheLibrarysOwnMethods) {
  const std::string file = testing::TempDir() + "rayproof_own_bugreport_" + std::to_string(::getpid());
  std::ofstream(file)
      << R"({"subject": "sphere/textbook", "shape": "sphere", "method": "textbook", "property": "verdict", )"
      << R"("kind": "gross", "case": {"ray": {"origin": [0,0,-5], "direction": [0,0,1]}, )"
      << R"("shape": {"type": "sphere", "center": [0,0,0], "radius": 1}}, "got": {"verdict": "miss"}})"
      << "\n";
  const test::Ended ended = test::run(RAYPROOF_BIN_DIR "/rayproof-bugreport 1 --from " + file);
  EXPECT_EQ(ended.status, 1);
  EXPECT_NE(ended.output.find("finding 1 is of this library's own method sphere/textbook"), std::string::npos)
      << ended.output;
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace rayproof
