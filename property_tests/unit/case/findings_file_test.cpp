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

TEST(FindingsFile, BlankLinesAreCountedAsAnEditorDoes) {
  EXPECT_EQ(lines_in("a\n\nb\n"), (std::vector<std::string>{"a", "", "b"}));
  EXPECT_TRUE(lines_in("").empty());
  for (const char* blank : {"", " \t\r"}) EXPECT_TRUE(is_blank(blank));
  EXPECT_FALSE(is_blank(" {}"));
}

TEST(FindingsFile, FindingNIsLineNAndWhatIsMissingIsNamed) {
  const auto folder = std::filesystem::path(testing::TempDir()) / ("findings_" + std::to_string(::getpid()));
  const auto file = folder / "findings.jsonl";
  std::filesystem::create_directories(folder);
  std::ofstream(file) << "first\n\nthird\n";
  EXPECT_EQ(finding_line(file.string(), 3), "third");
  EXPECT_EQ(finding_line(folder.string(), 3), "third");
  const auto complaint = [](const std::string& name, std::size_t number) -> std::string {
    try {
      return finding_line(name, number);
    } catch (const UnreadableCase& why) {
      return why.what();
    }
  };
  EXPECT_EQ(complaint(file.string(), 4), "there is no finding 4: " + file.string() + " holds 3");
  EXPECT_EQ(complaint(file.string(), 2),
            "there is no finding 2: that line of " + file.string() + " is blank");
  EXPECT_NE(complaint("no/such/file", 1).find("no/such/file can't be read"), std::string::npos);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace rayproof
