#include "case/findings_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace rayproof {
namespace {

TEST(FindingsFile, ANumberIsDigitsAloneAndNotZero) {
  EXPECT_EQ(finding_number("12"), 12U);
  for (const char* text : {"", "0", "-1", "+1", "1.5", "12a", " 12", "./12", "{}", "99999999999999999999999"})
    EXPECT_FALSE(finding_number(text)) << text;
}

TEST(FindingsFile, BlankLinesAreNotCounted) {
  EXPECT_EQ(lines_in("a\n\n \t\r\nb"), (std::vector<std::string>{"a", "b"}));
  EXPECT_TRUE(lines_in("\n\n").empty());
}

TEST(FindingsFile, FindingNIsLineNAndWhatIsMissingIsNamed) {
  const auto file = std::filesystem::path(testing::TempDir()) / ("findings_" + std::to_string(::getpid()));
  std::ofstream(file) << "first\nsecond\n";
  EXPECT_EQ(finding_line(file.string(), 2), "second");
  const auto complaint = [](const std::string& name, std::size_t number) -> std::string {
    try {
      return finding_line(name, number);
    } catch (const UnreadableCase& why) {
      return why.what();
    }
  };
  EXPECT_EQ(complaint(file.string(), 3), "there is no finding 3: " + file.string() + " holds 2");
  EXPECT_NE(complaint("no/such/file", 1).find("no/such/file can't be read"), std::string::npos);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace rayproof
