/// \file
/// rayproof check --subject-command with programs that are right, and with programs that misbehave, each in
/// one way.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "unit/command.hpp"

namespace rayproof {
namespace {

using test::Ended;

const std::string programs = std::string(RAYPROOF_SOURCE_DIR) + "/property_tests/unit/guests/";

class Guests : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  /// Puts a shell line on trial.
  [[nodiscard]] Ended check(const std::string& command, const std::string& arguments) const {
    return test::run("cd " + folder_.string() + " && unset PYTHONUNBUFFERED; " + RAYPROOF_BIN_DIR +
                     "/rayproof-check --subject-command '" + command + "' --cases 100 --jobs 2 " + arguments);
  }
  /// The same of misbehaving.py with that fault. Where silence is to be found it is short; else the machine
  /// may be busy.
  [[nodiscard]] Ended check_fault(const std::string& fault) const {
    constexpr std::array silent{"hang", "late", "leave_out", "hang_once", "flush_seldom", "leave_child"};
    const bool is_silent = std::ranges::find(silent, fault) != silent.end();
    return check(
        "python3 " + programs + "misbehaving.py " + fault,
        std::string("--shape sphere --precision float64 --family random,transformed --case-seconds ") +
            std::string(is_silent ? "0.7" : "5"));
  }
  [[nodiscard]] std::vector<nlohmann::json> findings() const {
    std::vector<nlohmann::json> all;
    std::ifstream in(folder_ / "out/check/findings.jsonl");
    for (std::string line; std::getline(in, line);) all.push_back(nlohmann::json::parse(line));
    return all;
  }
  /// Expects one finding of the protocol whose sentence has these words.
  void expect_protocol(const std::string& fault, const std::string& words) const {
    const Ended outcome = check_fault(fault);
    EXPECT_EQ(outcome.status, 1) << outcome.output;
    const auto found = findings();
    ASSERT_EQ(found.size(), 1U) << outcome.output;
    EXPECT_EQ(found[0]["property"], "answers");
    EXPECT_EQ(found[0]["kind"], "protocol");
    const std::string sentence = found[0]["got"]["error"];
    EXPECT_NE(sentence.find(words), std::string::npos) << sentence;
  }
  /// Expects that to be found on a case that misbehaving.py chooses.
  void expect_chosen(const std::string& fault, const std::string& words) const {
    expect_protocol(fault, words);
    const auto found = findings();
    ASSERT_FALSE(found.empty());
    EXPECT_TRUE(found[0]["case"].contains("transform")) << found[0];
    EXPECT_LT(found[0]["case"]["ray"]["direction"][0].get<double>(), 0) << found[0];
  }

 private:
  std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) / ("rayproof_guests_" + std::to_string(::getpid()));
};

TEST_F(Guests, APlainRightProgramGetsACleanBillInEveryShape) {
  const Ended outcome = check("python3 " + programs + "right.py", "");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_NE(outcome.output.find("a clean bill"), std::string::npos);
  EXPECT_NE(outcome.output.find("never judged of a program: nan (every case sent is valid)"),
            std::string::npos);
  EXPECT_NE(outcome.output.find("points on the boundary (it never says so)"), std::string::npos);
}

TEST_F(Guests, WhatAProgramLeavesOutIsNotJudged) {
  for (const auto& [fault, words] : {std::pair{"verdict_only", "residual, ascending (no t is given)"},
                                     std::pair{"nearest_only", "hits behind the nearest (none is given)"}}) {
    const Ended outcome = check_fault(fault);
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    const std::size_t at = outcome.output.find("not judged");
    EXPECT_NE(outcome.output.find(words, at), std::string::npos) << outcome.output;
  }
}

TEST_F(Guests, AnswersMayComeOutOfOrder) { EXPECT_EQ(check_fault("out_of_order").status, 0); }

TEST_F(Guests, AProgramThatDeclinesEverythingIsOneLineAndNoCleanBill) {
  const Ended outcome = check_fault("unsupported");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.output.find("unsupported: the program says so of all"), std::string::npos)
      << outcome.output;
  EXPECT_NE(outcome.output.find("nothing was judged"), std::string::npos);
}

TEST_F(Guests, ACrashIsFoundWithItsCaseAndItsLastWords) {
  expect_chosen("crash", "was ended by signal 6");
  EXPECT_NE(findings().at(0)["got"]["error"].get<std::string>().find("about to fall"), std::string::npos);
}
TEST_F(Guests, AHangIsFoundWithItsCase) { expect_chosen("hang", "no answer within 0.7 s"); }
TEST_F(Guests, ALateAnswerIsFoundWithItsCase) { expect_chosen("late", "no answer within 0.7 s"); }
TEST_F(Guests, SilenceThatIsNoCasesOwnIsFound) {
  for (const char* const fault : {"leave_out", "hang_once"})
    expect_protocol(fault, "no answer within 0.7 s; asked alone, it answers the case");
}
TEST_F(Guests, NonsenseIsFoundWithItsCase) { expect_chosen("nonsense_once", "What a nice ray!"); }
TEST_F(Guests, NaNIsFoundWithItsCase) { expect_chosen("not_a_number", "NaN"); }
TEST_F(Guests, NaNInQuotesIsFoundWithItsCase) {
  expect_chosen("nan_in_quotes", "wrote a line that is no answer: hits[0].t is NaN");
}
TEST_F(Guests, ASecondAnswerIsFoundWithItsCase) { expect_chosen("twice_once", "answered the case twice"); }
TEST_F(Guests, AnUnknownIdIsFoundWithItsCase) { expect_chosen("wrong_id", "an id that no case has"); }
TEST_F(Guests, AMissingIdIsFoundWithItsCase) { expect_chosen("without_id", "without the id"); }
TEST_F(Guests, AnErrorIsFoundWithItsCase) { expect_chosen("give_up", "gave up: I cannot do this"); }

TEST_F(Guests, WhoFailsAlwaysIsOneFinding) {
  expect_protocol("crash_at_once", "was ended by signal 6");
  expect_protocol("nonsense", "What a nice ray!");
  expect_protocol("twice", "answered the case twice");
  expect_protocol("end_early", "ended with exit status 0");
  expect_protocol("close_output", "closed its output");
}
TEST_F(Guests, WhoSaysNothingIsOneFinding) { expect_protocol("ignore_input", "no answer within"); }
TEST_F(Guests, WhoNeverEndsALineIsOneFinding) {
  expect_protocol("endless_line", "without the end of a line");
}
TEST_F(Guests, WhoNeverFlushesLearnsThat) { expect_protocol("never_flush", "each line must be flushed"); }

TEST_F(Guests, WhoFlushesSeldomLearnsThatToo) {
  expect_protocol("flush_seldom", "each line must be flushed");
}
TEST_F(Guests, WhoEndsAndLeavesAProcessWithItsOutputIsSaidTo) {
  expect_chosen("leave_child", "ended with exit status 3, and a process that it has started");
}

TEST_F(Guests, StandardErrorMayBeLongAndNotEndless) {
  EXPECT_EQ(check_fault("complain").status, 0);
  expect_protocol("complain_endlessly", "wrote more than 1 GB to standard error");
}

TEST_F(Guests, ACommandThatCannotBeStartedEndsWithTwoAndOneSentence) {
  const Ended outcome = check("no-such-program --fast", "--shape sphere");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 1) << outcome.output;
  EXPECT_NE(outcome.output.find("cannot be started"), std::string::npos) << outcome.output;
}

}  // namespace
}  // namespace rayproof
