/// \file
/// A program that cannot write a file ends with 2, and leaves the old one whole.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "unit/command.hpp"

namespace rayproof {
namespace {

namespace fs = std::filesystem;

class FullDisk : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder / "out"); }
  void TearDown() override { fs::remove_all(folder); }

  /// Runs a program where no file can grow beyond one block, with an old file in the place of its output.
  /// Nothing but that may be there afterwards.
  void expect_the_old_file(const std::string& command, const std::string& name) {
    const std::string program = RAYPROOF_BIN_DIR "/rayproof-" + command;
    if (!fs::exists(program.substr(0, program.find(' ')))) return;
    std::ofstream(folder / "out" / name) << "old";
    const test::Ended ended = test::run("cd " + folder.string() + "; trap '' XFSZ; ulimit -f 1; " + program);
    EXPECT_EQ(ended.status, 2) << command;
    EXPECT_NE(ended.output.find("out/" + name + " cannot be written: "), std::string::npos) << ended.output;
    std::ifstream in(folder / "out" / name);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), "old") << command;
    EXPECT_EQ(std::distance(fs::directory_iterator(folder / "out"), {}), 1) << command;
    fs::remove(folder / "out" / name);
  }

  fs::path folder = fs::path(testing::TempDir()) / ("rayproof_full_disk_" + std::to_string(::getpid()));
};

TEST_F(FullDisk, LeavesTheOldFileOfASearchWhole) {
  expect_the_old_file("worst --shape sphere --cases 100 --out out", "findings.jsonl");
  expect_the_old_file("spawn --shape sphere --cases 10 --json out/all.json", "all.json");
}

TEST_F(FullDisk, LeavesTheOldPageWhole) {
  const std::string given =
      R"('{"ray":{"origin":[0,0,-5],"direction":[0,0,1]},"shape":{"type":"sphere","center":[0,0,0],"radius":1}}' )";
  expect_the_old_file("draw " + given + "--html out/a.html", "a.html");
  expect_the_old_file("draw " + given + "--svg out/a.svg", "a.svg");
  expect_the_old_file("walk ray --html out/a.html", "a.html");
}

}  // namespace
}  // namespace rayproof
