/// \file
/// rayproof draw N on the findings of rayproof check --subject-command.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "unit/command.hpp"

namespace rayproof::viz {
namespace {

using test::Ended;

class GuestPictures : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] Ended in_folder(const std::string& command) const {
    return test::run("cd " + folder_.string() + " && " + RAYPROOF_BIN_DIR + "/rayproof-" + command);
  }
  [[nodiscard]] Ended check(const std::string& program) const {
    return in_folder("check --subject-command 'python3 " RAYPROOF_SOURCE_DIR "/property_tests/unit/guests/" +
                     program + "' --shape sphere --precision float64 --family random --cases 40 --jobs 2");
  }
  [[nodiscard]] std::string text_of(const std::string& file) const {
    std::ifstream in(folder_ / file);
    return {std::istreambuf_iterator<char>(in), {}};
  }

 private:
  std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) / ("rayproof_guest_pictures_" + std::to_string(::getpid()));
};

TEST_F(GuestPictures, ShowWhatTheProgramClaimsBesideWhatIsExact) {
  EXPECT_EQ(check("faulty.py other_sign").status, 1);
  const Ended drawn = in_folder("draw 1");
  EXPECT_EQ(drawn.status, 0) << drawn.output;
  EXPECT_EQ(drawn.output, "out/check/draw-1.html\n");
  const std::string page = text_of("out/check/draw-1.html");
  for (const char* const word : {"<svg", "exact, correctly rounded", "claimed", "sphere/command"})
    EXPECT_NE(page.find(word), std::string::npos) << word;
}

TEST_F(GuestPictures, ShowTheExactAnswerAloneWithTheReasonWhereTheProgramGivesNone) {
  EXPECT_EQ(check("misbehaving.py nonsense").status, 1);
  const Ended drawn = in_folder("draw 1");
  EXPECT_EQ(drawn.status, 0);
  EXPECT_NE(drawn.output.find("wrote a line that is no answer"), std::string::npos) << drawn.output;
  const std::string page = text_of("out/check/draw-1.html");
  EXPECT_NE(page.find("exact, correctly rounded"), std::string::npos);
}

}  // namespace
}  // namespace rayproof::viz
