/// \file
/// Ctrl-C ends a search with 130, after what was found until then and a last line that claims no more.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "unit/command.hpp"

namespace rayproof {
namespace {

/// Interrupts a program a second after it began; the last two lines of what it printed, and its status.
test::Ended interrupted(const std::string& command) {
  const std::string folder = testing::TempDir() + "rayproof_interrupted_" + std::to_string(::getpid());
  std::filesystem::create_directories(folder);
  const test::Ended ended =
      test::run("cd " + folder + " && timeout --preserve-status -s INT 1 " RAYPROOF_BIN_DIR "/rayproof-" +
                command + " > out.txt 2>&1; status=$?; tail -n 2 out.txt; exit $status");
  std::filesystem::remove_all(folder);
  return ended;
}

TEST(Interrupted, SpawnSaysOfWhatWasJudgedThatNothingProvenIsBroken) {
  const test::Ended ended = interrupted("spawn --cases 1e9 --strategy proven --jobs 2");
  EXPECT_EQ(
      ended.output,
      "interrupted: only what is shown was judged\nnothing that is proven is broken by what was judged\n");
  EXPECT_EQ(ended.status, 130);
}

TEST(Interrupted, LeakSaysOfWhatWasJudgedThatNobodyLeaks) {
  const test::Ended ended = interrupted("leak cube --rays 1e9 --method woop --jobs 2");
  EXPECT_EQ(ended.output,
            "interrupted: only what is shown was judged\n"
            "nobody who should be tight leaks or hits twice in what was judged\n");
  EXPECT_EQ(ended.status, 130);
}

TEST(Interrupted, ReportSaysThatItMeasuredNoMoreThanItShows) {
  if (!std::filesystem::exists(RAYPROOF_BIN_DIR "/rayproof-report")) GTEST_SKIP() << "report is not built";
  const test::Ended ended = interrupted("report --shape plane");
  EXPECT_NE(ended.output.find("interrupted"), std::string::npos) << ended.output;
  EXPECT_EQ(ended.status, 130);
}

TEST(Interrupted, WalkLeavesPagesWithTheirScriptAndAGalleryOfThem) {
  if (!std::filesystem::exists(RAYPROOF_BIN_DIR "/rayproof-walk")) GTEST_SKIP() << "walk is not built";
  const std::filesystem::path folder =
      testing::TempDir() + "rayproof_interrupted_walk_" + std::to_string(::getpid());
  std::filesystem::remove_all(folder);
  const test::Ended ended =
      test::run("env -u DISPLAY " RAYPROOF_BIN_DIR "/rayproof-walk all --html " + folder.string() +
                " & walk=$!; while [ -d /proc/$walk ] && ! ls " + folder.string() +
                "/*.html >/dev/null 2>&1; do sleep 0.02; done; kill -INT $walk; wait $walk");
  EXPECT_EQ(ended.status, 130) << ended.output;
  EXPECT_NE(ended.output.find(" pages are written, and " + (folder / "index.html").string() + " shows those"),
            std::string::npos)
      << ended.output;
  EXPECT_TRUE(std::filesystem::exists(folder / "walkthrough.js"));
  EXPECT_TRUE(std::filesystem::exists(folder / "index.html"));
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace rayproof
