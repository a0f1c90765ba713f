/// \file
/// Campaigns as somebody outside runs them: in shards, killed and gone on with, side by side.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "unit/command.hpp"

namespace rayproof {
namespace {

/// A folder of its own for each test, gone with the object. Every campaign writes to `out/check` of some
/// folder in it.
class CampaignProgram : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] test::Ended run_in(const std::string& name, const std::string& command) const {
    std::filesystem::create_directories(folder_ / name);
    return test::run("cd " + (folder_ / name).string() + " && PATH=" + RAYPROOF_BIN_DIR + ":$PATH && " +
                     command);
  }

  [[nodiscard]] std::string text_of(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(folder_ / name).rdbuf();
    return text.str();
  }

  /// All that two campaigns wrote is the same.
  void expect_same(const std::string& one, const std::string& other) const {
    for (const char* const file : {"campaign.json", "findings.jsonl", "index.html"}) {
      const std::string text = text_of(one + "/out/check/" + file);
      EXPECT_GT(text.size(), 100U) << file;
      EXPECT_TRUE(text == text_of(other + "/out/check/" + file)) << file;
    }
  }

 private:
  std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) / ("rayproof_campaign_" + std::to_string(::getpid()));
};

const std::string campaign =
    "rayproof-check --campaign --cases 4e5 --shape quadratic --method textbook --family random,whole";

TEST_F(CampaignProgram, TwoShardsMergedAreByteForByteOneRun) {
  ASSERT_EQ(run_in("whole", campaign).status, 0);
  for (const char* const shard : {"1", "2"})
    ASSERT_EQ(run_in(shard, campaign + " --shard " + shard + "/2").status, 0);
  const test::Ended merged =
      run_in("merged", "rayproof-merge ../1/out/check ../2/out/check/campaign.json --out out/check");
  ASSERT_EQ(merged.status, 0) << merged.output;
  expect_same("whole", "merged");
}

TEST_F(CampaignProgram, KilledAndResumedIsByteForByteOneRun) {
  ASSERT_EQ(run_in("whole", campaign).status, 0);
  const test::Ended stopped =
      run_in("killed", campaign + " --time 1s --jobs 1 & sleep 0.3; kill -INT $!; wait $!");
  EXPECT_TRUE(stopped.status == 130 || stopped.status == 0) << stopped.output;
  (void)run_in("killed", "timeout -s KILL 0.4 " + campaign + " --resume");
  ASSERT_EQ(run_in("killed", campaign + " --resume").status, 0);
  expect_same("whole", "killed");
}

TEST_F(CampaignProgram, DoesNotOverwriteWhatAnotherFound) {
  ASSERT_EQ(run_in("one", campaign).status, 0);
  const std::string before = text_of("one/out/check/campaign.json");
  const test::Ended again = run_in("one", campaign);
  EXPECT_EQ(again.status, 2);
  EXPECT_NE(again.output.find("--resume goes on with it"), std::string::npos) << again.output;
  const test::Ended other = run_in("one", campaign + " --seed 3 --resume");
  EXPECT_EQ(other.status, 2);
  EXPECT_NE(other.output.find("holds another campaign"), std::string::npos) << other.output;
  EXPECT_EQ(text_of("one/out/check/campaign.json"), before);
}

TEST_F(CampaignProgram, AMistakeEndsWithTwoAndOneSentence) {
  for (const char* const mistake :
       {"--campaign --cases 1.5", "--campaign --cases 1e13", "--campaign --shard 0/2",
        "--campaign --shard 3/2", "--campaign --shard half", "--shard 1/2", "--resume",
        "--campaign --subject-command true", "--campaign --time 5x"}) {
    const test::Ended ended = run_in("one", std::string("rayproof-check ") + mistake);
    EXPECT_EQ(ended.status, 2) << mistake;
    EXPECT_EQ(std::count(ended.output.begin(), ended.output.end(), '\n'), 1) << ended.output;
  }
}

/// One sentence, and the status 2.
void expect_refused(const test::Ended& ended, const std::string& reason) {
  EXPECT_EQ(ended.status, 2) << ended.output;
  EXPECT_EQ(std::count(ended.output.begin(), ended.output.end(), '\n'), 1) << ended.output;
  EXPECT_NE(ended.output.find(reason), std::string::npos) << ended.output;
}

TEST_F(CampaignProgram, MergesNothingThatIsNotOneCampaign) {
  ASSERT_EQ(run_in("1", campaign + " --shard 1/2").status, 0);
  ASSERT_EQ(run_in("2", campaign + " --shard 2/2").status, 0);
  (void)run_in("seed", campaign + " --shard 2/2 --seed 3");
  (void)run_in("property", campaign + " --shard 2/2 --property verdict");
  const auto merge = [&](const std::string& shards, const std::string& out = "x") {
    return run_in("merged", "cd .. && rayproof-merge " + shards + " --out " + out);
  };
  expect_refused(merge("nowhere"), "nowhere cannot be read");
  expect_refused(merge("1"), "1/campaign.json cannot be read");
  expect_refused(merge("1/out/check"), "shard 2/2 is missing");
  expect_refused(merge("1/out/check 1/out/check"), "shard 1/2 is given twice");
  for (const char* const other : {"seed", "property"})
    expect_refused(merge(std::string("1/out/check ") + other + "/out/check"), "are not of one campaign");
  (void)run_in("cut", "mkdir -p out && head -c 900 ../2/out/check/campaign.json > out/campaign.json");
  expect_refused(merge("1/out/check cut/out"), "it is no state of a campaign");
  const std::string before = text_of("1/out/check/campaign.json");
  expect_refused(merge("1/out/check 2/out/check", "1/out/check"), "--out names another folder");
  EXPECT_EQ(text_of("1/out/check/campaign.json"), before);
}

TEST_F(CampaignProgram, ThatIsShortOfTimeEndsWithinARound) {
  const std::string many = "rayproof-check --campaign --cases 1e7 --shape polygon,cylinder --jobs 1";
  const test::Ended ended = run_in("short", many + " --time 0.1");
  EXPECT_LE(ended.status, 1) << ended.output;
  const std::string state = text_of("short/out/check/campaign.json");
  EXPECT_NE(state.find("\"rounds\": 0,"), std::string::npos);
  EXPECT_EQ(state.find("\"units ahead\": 0,"), std::string::npos) << "some of the round is done, and kept";
}

/// A disk on which no file can grow beyond one block.
const std::string on_a_full_disk = "trap '' XFSZ; ulimit -f 1; ";

TEST_F(CampaignProgram, LosesNothingOnAFullDisk) {
  (void)run_in("full", campaign + " --time 0.01 --jobs 1");
  const std::string before = text_of("full/out/check/campaign.json");
  ASSERT_GT(before.size(), 1024U);
  expect_refused(run_in("full", on_a_full_disk + campaign + " --resume"), "campaign.json cannot be written");
  EXPECT_EQ(text_of("full/out/check/campaign.json"), before);
  expect_refused(run_in("fresh", on_a_full_disk + campaign), "campaign.json cannot be written");
  EXPECT_EQ(text_of("fresh/out/check/campaign.json"), "");
}

TEST_F(CampaignProgram, HasItsFolderForItself) {
  const std::string endless = "rayproof-check --campaign --cases 1e10 --shape quadratic --method textbook";
  (void)run_in("one", "{ " + endless +
                          " > first.txt 2>&1 & i=0; while ! test -e out/check/campaign.json && test $((i += "
                          "1)) -lt 300; do sleep 0.1; done; " +
                          endless +
                          " --resume > second.txt 2>&1; echo $? >> second.txt; kill -INT $!; wait; }");
  EXPECT_EQ(text_of("one/second.txt"),
            "rayproof check: another check or campaign is running in out/check\n2\n");
}

TEST_F(CampaignProgram, ShardsRunSideBySideUnderGnuParallel) {
  if (test::run("parallel --version").status != 0) GTEST_SKIP() << "GNU parallel is not installed";
  ASSERT_EQ(run_in("whole", campaign).status, 0);
  const test::Ended shards = run_in(
      "parts", "parallel --will-cite -j 2 " + campaign + " --jobs 1 --shard {}/4 --out shard{} ::: 1 2 3 4");
  ASSERT_EQ(shards.status, 0) << shards.output;
  const test::Ended merged = run_in("parts", "rayproof-merge shard1 shard2 shard3 shard4 --out out/check");
  ASSERT_EQ(merged.status, 0) << merged.output;
  expect_same("whole", "parts");
}

}  // namespace
}  // namespace rayproof
