/// \file
/// rayproof check --subject-command with programs that answer in time, and wrongly in one way.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "unit/command.hpp"

namespace rayproof {
namespace {

using test::Ended;

const std::string guests = std::string(RAYPROOF_SOURCE_DIR) + "/property_tests/unit/guests/";

/// A fault, the shape that shows it, and what the diagnosis must say.
struct FaultyGuest {
  const char* fault;
  const char* arguments;
  const char* words;
};
void PrintTo(const FaultyGuest& one, std::ostream* out) { *out << one.fault; }

class FaultyGuests : public testing::TestWithParam<FaultyGuest> {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] Ended in_folder(const std::string& command) const {
    return test::run("cd " + folder_.string() + " && " + RAYPROOF_BIN_DIR + "/" + command);
  }
  [[nodiscard]] std::vector<nlohmann::json> findings() const {
    std::vector<nlohmann::json> all;
    std::ifstream in(folder_ / "out/check/findings.jsonl");
    for (std::string line; std::getline(in, line);) all.push_back(nlohmann::json::parse(line));
    return all;
  }

 private:
  std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) / ("rayproof_faulty_guests_" + std::to_string(::getpid()));
};

TEST_P(FaultyGuests, AreFoundWithTheirDiagnosis) {
  const FaultyGuest& one = GetParam();
  const Ended outcome =
      in_folder("rayproof-check --subject-command 'python3 " + guests + "faulty.py " + one.fault +
                "' --precision float64 --case-seconds 10 --jobs 2 --cases 400 " + one.arguments);
  EXPECT_EQ(outcome.status, 1) << outcome.output;
  bool is_named = false;
  for (const nlohmann::json& finding : findings())
    is_named = is_named || finding.value("diagnosis", "").find(one.words) != std::string::npos;
  EXPECT_TRUE(is_named) << outcome.output;
}

INSTANTIATE_TEST_SUITE_P(
    Programs, FaultyGuests,
    testing::Values(FaultyGuest{"open_at_t_min", "--shape plane --family whole", "t_min"},
                    FaultyGuest{"open_at_t_max", "--shape plane --family whole", "t_max"},
                    FaultyGuest{"rounded", "--shape plane --family random", "six decimals"},
                    FaultyGuest{"half", "--shape plane --family random", "half precision"},
                    FaultyGuest{"in_plane", "--shape plane --family whole", "reported as a hit"},
                    FaultyGuest{"other_sign", "--shape sphere --family random", "other sign"},
                    FaultyGuest{"point_alone", "--shape plane --family random", "the origin is missing"},
                    FaultyGuest{"rare", "--shape plane --family random", "asked this case alone"},
                    FaultyGuest{"uncapped", "--shape cylinder --family random", "caps are missing"}),
    [](const auto& one) { return std::string(one.param.fault); });

class GuestsWithOneFault : public FaultyGuests {};

TEST_F(GuestsWithOneFault, GetOneFindingThoughAnEpsilonMissesTangentsToo) {
  const Ended outcome = in_folder("rayproof-check --subject-command 'python3 " + guests +
                                  "faulty.py small_discriminant' --shape sphere --case-seconds 10 --jobs 2 "
                                  "--cases 200 --family random,grazing,whole,exponents");
  ASSERT_EQ(findings().size(), 1U) << outcome.output;
  EXPECT_NE(findings()[0].value("diagnosis", "").find("absolute epsilon"), std::string::npos)
      << outcome.output;
}

TEST_F(GuestsWithOneFault, GiveTheNearestHitAloneAndLearnThatFromAfarItsDigitsCancel) {
  const Ended outcome = in_folder("rayproof-check --subject-command 'python3 " + guests +
                                  "faulty.py nearest_by_textbook' --shape sphere --case-seconds 10 --jobs 2 "
                                  "--cases 400 --family far,random");
  EXPECT_EQ(outcome.status, 0) << "lost digits alone spoil no bill";
  ASSERT_EQ(findings().size(), 1U) << outcome.output;
  EXPECT_NE(findings()[0].value("diagnosis", "").find("starts near the shape"), std::string::npos)
      << outcome.output;
}

class HangingGuests : public FaultyGuests {
 protected:
  [[nodiscard]] Ended check_hanging(const std::string& more) const {
    return in_folder(
        "rayproof-check --subject-command 'python3 " + guests +
        "misbehaving.py hang' --shape sphere --precision float64 --family transformed --cases 100 " + more);
  }
};

TEST_F(HangingGuests, AreDrawnAndReplayedInTheirOwnTime) {
  EXPECT_EQ(check_hanging("--case-seconds 0.7").status, 1);
  ASSERT_EQ(findings().size(), 1U);
  EXPECT_EQ(findings()[0].value("case_seconds", 0.0), 0.7);
  const Ended replayed = in_folder("rayproof-replay 1");
  EXPECT_EQ(replayed.status, 1);
  EXPECT_NE(replayed.output.find("no answer within 0.7 s"), std::string::npos) << replayed.output;
}

TEST_F(HangingGuests, EndWithTheCheckAtCtrlC) {
  const Ended outcome =
      in_folder("rayproof-check --help > /dev/null; timeout -s INT 4 " RAYPROOF_BIN_DIR
                "/rayproof-check --subject-command 'sleep 98765' "
                "--shape sphere --case-seconds 100; echo status $?; pgrep -f '^sleep 98765'");
  // timeout gives 124; pgrep would print the number of a process that is left.
  EXPECT_TRUE(outcome.output.ends_with("status 124\n")) << outcome.output;
}

}  // namespace
}  // namespace rayproof
