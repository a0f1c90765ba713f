#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

#include "properties/diagnosis/hypothesis.hpp"

namespace rayproof {
namespace {

/// A cell of a table in Markdown, in which a bar would end it.
std::string cell_of(std::string_view sentence) {
  std::string cell;
  for (const char c : sentence) cell += c == '|' ? "\\|" : std::string(1, c);
  return cell;
}

/// The table of docs/diagnosis.md as the registry has it.
std::string table_of(bool are_cures) {
  std::string table = "| name | kind | in words |\n| --- | --- | --- |\n";
  for (const Hypothesis& one : hypotheses())
    if ((one.change != nullptr) == are_cures)
      table += fmt::format("| `{}` | {} | {} |\n", one.name, name_of(one.kind), cell_of(one.sentence));
  return table;
}

TEST(DiagnosisPage, HasTheTablesOfTheRegistry) {
  std::ifstream file(RAYPROOF_SOURCE_DIR "/docs/diagnosis.md");
  std::stringstream page;
  page << file.rdbuf();
  for (const bool are_cures : {false, true})
    EXPECT_NE(page.str().find("\n" + table_of(are_cures)), std::string::npos)
        << "docs/diagnosis.md must have this table:\n"
        << table_of(are_cures);
}

TEST(DiagnosisRegistry, HasEachNameOnce) {
  for (const Hypothesis& one : hypotheses()) {
    EXPECT_EQ(find_hypothesis(one.name), &one) << one.name;
    EXPECT_FALSE(one.sentence.empty()) << one.name;
    const int functions = (one.predict != nullptr ? 1 : 0) + (one.recognise != nullptr ? 1 : 0) +
                          (one.change != nullptr ? 1 : 0);
    EXPECT_EQ(functions, 1) << one.name;
  }
  EXPECT_EQ(find_hypothesis("no such thing"), nullptr);
}

}  // namespace
}  // namespace rayproof
