/// \file
/// rayproof check as somebody outside meets it: what it writes, and how it ends.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <sstream>

#include "subjects/subject.hpp"
#include "unit/command.hpp"

namespace rayproof {
namespace {

using test::Ended;

/// A folder of its own for each test, gone with the object.
class CheckProgram : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }

  [[nodiscard]] std::string text_of(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(path(name)).rdbuf();
    return text.str();
  }

  /// Runs the program in the folder; `before` stands before it on the command line.
  [[nodiscard]] Ended check(const std::string& arguments, const std::string& before = "") const {
    return test::run("cd " + folder_.string() + " && " + before + " " + RAYPROOF_BIN_DIR +
                     "/rayproof-check " + arguments);
  }

 private:
  std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) / ("rayproof_check_" + std::to_string(::getpid()));
};

const std::string short_refutation = "--cases 3000 --method printed_2ac --precision float32";

TEST_F(CheckProgram, AMistakeOnTheCommandLineEndsWithTwoAndOneSentence) {
  for (const char* mistake :
       {"--no-such-option", "--cases 0", "--method nobody", "--family nowhere", "--property none",
        "--shape cube", "--precision float16", "--shape quadratic --method centred", "--replay no-such-file",
        "--replay f.jsonl --subject-command cat", "--corpus no-such-file", "--json no/such/folder/file"}) {
    const Ended outcome = check(mistake);
    EXPECT_EQ(outcome.status, 2) << mistake;
    EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 1) << outcome.output;
  }
}

TEST_F(CheckProgram, HelpEndsWithZeroAndNamesEveryTopic) {
  const Ended help = check("--help");
  EXPECT_EQ(help.status, 0);
  for (const std::string& topic : topics())
    EXPECT_NE(help.output.find(topic), std::string::npos) << topic << "\n" << help.output;
}

/// Columns on a terminal: every sign that check prints is one wide.
std::ptrdiff_t columns(const std::string& line) {
  return std::count_if(line.begin(), line.end(),
                       [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; });
}

/// The numbers at the beginning of a line, as in "35-40  sphere/textbook …".
std::vector<int> numbers_at(const std::string& line) {
  int first = 0, last = 0;
  const int read = std::sscanf(line.c_str(), "%d-%d  ", &first, &last);
  std::vector<int> numbers;
  for (int number = first; read >= 1 && number <= (read == 2 ? last : first); ++number)
    numbers.push_back(number);
  return numbers;
}

TEST_F(CheckProgram, AWholeCheckFits100LinesOf120ColumnsWithEveryFinding) {
  const Ended outcome = check("--cases 200 2>/dev/null");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_LE(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 100) << outcome.output;
  std::vector<int> listed;
  std::istringstream lines(outcome.output);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LE(columns(line), 120) << line;
    for (const int number : numbers_at(line)) listed.push_back(number);
  }
  const std::string findings = text_of("out/check/findings.jsonl");
  std::vector<int> wanted(static_cast<std::size_t>(std::count(findings.begin(), findings.end(), '\n')));
  std::iota(wanted.begin(), wanted.end(), 1);
  EXPECT_GT(wanted.size(), 50U);
  EXPECT_EQ(listed, wanted);
}

TEST_F(CheckProgram, AMethodDeclaredWrongIsRefutedAndThatIsASuccess) {
  const Ended outcome = check(short_refutation + " --findings f.jsonl --junit j.xml --json j.json");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_NE(outcome.output.find("sphere/printed_2ac float32  hits a sphere"), std::string::npos)
      << outcome.output;
  EXPECT_NE(text_of("f.jsonl").find("\"subject\": \"sphere/printed_2ac\""), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(text_of("j.json")).at("success"), true);
  EXPECT_NE(text_of("j.xml").find("<testsuites"), std::string::npos);
  EXPECT_NE(text_of("out/check/index.html").find("<svg"), std::string::npos);
}

TEST_F(CheckProgram, ARefutationThatIsNotFoundIsAFailure) {
  // One case a family is too few to find the linear equation that refutes the declared claim.
  EXPECT_EQ(check("--cases 1 --method quadratic/textbook --property verdict").status, 1);
}

TEST_F(CheckProgram, FindingsAreReplayedAsTheyWereFound) {
  ASSERT_EQ(check(short_refutation + " --findings f.jsonl").status, 0);
  const Ended replayed = check("--replay f.jsonl");
  EXPECT_EQ(replayed.status, 0) << replayed.output;
  EXPECT_NE(replayed.output.find("as declared"), std::string::npos);
  EXPECT_EQ(replayed.output.find("does not break"), std::string::npos);
}

TEST_F(CheckProgram, AReplayedFindingThatIsNoneAnyMoreIsReported) {
  std::ofstream(path("f.jsonl"))
      << R"({"subject": "sphere/centred", "property": "verdict", "case": {"ray": {"origin": [0,0,-5], "direction": [0,0,1]}, "shape": {"type": "sphere", "center": [0,0,0], "radius": 1}}})"
      << "\n";
  const Ended replayed = check("--replay f.jsonl");
  EXPECT_EQ(replayed.status, 0) << replayed.output;
  EXPECT_NE(replayed.output.find("does not break"), std::string::npos);
}

TEST_F(CheckProgram, ALineThatCannotBeReplayedIsNamed) {
  std::ofstream(path("f.jsonl")) << "{}\n";
  const Ended replayed = check("--replay f.jsonl");
  EXPECT_EQ(replayed.status, 1);
  EXPECT_NE(replayed.output.find("f.jsonl:1: "), std::string::npos) << replayed.output;
}

TEST_F(CheckProgram, HasItsFolderForItself) {
  (void)check(
      "--method plane/implicit --cases 10 > first.txt 2>&1; exec 8< out/check; flock 8; " RAYPROOF_BIN_DIR
      "/rayproof-check --method plane/implicit --cases 10 > second.txt 2>&1; echo $? >> second.txt");
  EXPECT_EQ(text_of("second.txt"), "rayproof check: another check or campaign is running in out/check\n2\n");
  EXPECT_GT(text_of("out/check/index.html").size(), 1000U) << "what the first wrote stands";
}

TEST_F(CheckProgram, TheFindingsAreTheSameForEveryNumberOfJobs) {
  ASSERT_EQ(check(short_refutation + " --jobs 1 --findings one.jsonl").status, 0);
  ASSERT_EQ(check(short_refutation + " --jobs 2 --findings two.jsonl").status, 0);
  EXPECT_EQ(text_of("one.jsonl"), text_of("two.jsonl"));
}

/// Starts a run without an end and sends it SIGINT `times` times, `pause` apart, once it has found something.
std::string interrupted(const std::string& arguments, int times, const std::string& pause) {
  return "{ " RAYPROOF_BIN_DIR "/rayproof-check --cases 1000000000 " + arguments +
         " & P=$!; while ! test -s out/check/findings.jsonl; do sleep 0.05; done; for i in $(seq " +
         std::to_string(times) + "); do kill -INT $P 2>/dev/null; sleep " + pause + "; done; wait $P; }";
}

TEST_F(CheckProgram, InterruptsEndItCleanlyWithWhatWasFound) {
  for (const std::string pause : {"0", "0.02", "0.3"}) {
    std::filesystem::remove_all(path("out"));
    const Ended outcome =
        test::run("cd " + path(".") + " && " + interrupted("--method printed_2ac", 4, pause));
    EXPECT_EQ(outcome.status, 130) << outcome.output;
    EXPECT_NE(outcome.output.find("interrupted: only what is shown was checked"), std::string::npos);
    EXPECT_EQ(outcome.output.find("every contract holds"), std::string::npos) << outcome.output;
    EXPECT_NE(text_of("out/check/index.html").find("</html>"), std::string::npos);
    EXPECT_EQ(text_of("out/check/index.html").find("every contract holds"), std::string::npos);
    EXPECT_NE(text_of("out/check/findings.jsonl").find("sphere/printed_2ac"), std::string::npos);
  }
}

TEST_F(CheckProgram, BothSignalsOfTimeoutLoseNothing) {
  for (const std::string signal : {"INT", "TERM"}) {
    const Ended outcome = check("--cases 1000000000 --method printed_2ac", "timeout -s " + signal + " 3");
    EXPECT_NE(outcome.output.find("interrupted"), std::string::npos) << outcome.output;
    EXPECT_NE(text_of("out/check/index.html").find("</html>"), std::string::npos);
  }
}

TEST_F(CheckProgram, ATimeLimitIsKept) {
  const Ended outcome = check("--time 2 --cases 1000000000 --method printed_half_b", "timeout 60");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
}

}  // namespace
}  // namespace rayproof
