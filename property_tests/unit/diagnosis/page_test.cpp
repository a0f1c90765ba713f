#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "properties/diagnosis/hypothesis.hpp"

namespace rayproof {
namespace {

/// A cell of a table in Markdown, in which a bar would end it.
std::string cell_of(std::string_view sentence) {
  std::string cell;
  for (const char c : sentence) cell += c == '|' ? "\\|" : std::string(1, c);
  return cell;
}

constexpr std::string_view power_of_ten = R"(1e-?[0-9]+)";

/// One row for hypotheses that follow one another and differ in a power of ten alone, or in nothing.
struct RowOfFamily {
  std::string_view first, last, sentence, last_sentence;
  FindingKind kind{};

  /// "epsilon-1e-15" and "epsilon-1e-2" have one family.
  [[nodiscard]] static std::string family_of(std::string_view text) {
    return std::regex_replace(std::string(text), std::regex(power_of_ten.data()), "#");
  }
  [[nodiscard]] bool takes(const Hypothesis& next) const {
    return kind == next.kind && family_of(sentence) == family_of(next.sentence);
  }
  /// The first sentence with "1e-15 … 1e-2" for its power.
  [[nodiscard]] std::string words() const {
    std::smatch from, to;
    const std::string first_words(sentence), last_words(last_sentence);
    const std::regex power(power_of_ten.data());
    if (first_words == last_words || !std::regex_search(first_words, from, power) ||
        !std::regex_search(last_words, to, power))
      return cell_of(first_words);
    return cell_of(from.prefix().str() + from.str() + " … " + to.str() + from.suffix().str());
  }
  [[nodiscard]] std::string names() const {
    return first == last ? fmt::format("`{}`", first) : fmt::format("`{}` … `{}`", first, last);
  }
};

std::string table_of(const HypothesisTable& table) {
  std::vector<RowOfFamily> rows;
  for (const Hypothesis& one : table.lines) {
    if (!rows.empty() && rows.back().takes(one)) {
      rows.back().last = one.name;
      rows.back().last_sentence = one.sentence;
    } else {
      rows.push_back({one.name, one.name, one.sentence, one.sentence, one.kind});
    }
  }
  std::string text = fmt::format("### {}\n\n| name | kind | in words |\n| --- | --- | --- |\n", table.title);
  for (const RowOfFamily& row : rows)
    text += fmt::format("| {} | {} | {} |\n", row.names(), name_of(row.kind), row.words());
  return text;
}

/// Both sections of docs/diagnosis.md as the registry has them.
std::string sections() {
  std::string text[2];
  for (const HypothesisTable& table : hypothesis_tables())
    text[table.lines.front().change != nullptr ? 1 : 0] += "\n" + table_of(table);
  return "## Models\n" + text[0] + "\n## Cures\n" + text[1];
}

TEST(DiagnosisPage, HasTheTablesOfTheRegistry) {
  std::ifstream file(RAYPROOF_SOURCE_DIR "/docs/diagnosis.md");
  std::stringstream page;
  page << file.rdbuf();
  EXPECT_NE(page.str().find("\n" + sections() + "\n"), std::string::npos)
      << "docs/diagnosis.md must have these sections:\n"
      << sections() << "\n";
}

TEST(DiagnosisRegistry, HasTablesOfModelsAloneOrOfCuresAlone) {
  for (const HypothesisTable& table : hypothesis_tables()) {
    ASSERT_FALSE(table.lines.empty()) << table.title;
    const bool are_cures = table.lines.front().change != nullptr;
    for (const Hypothesis& one : table.lines) EXPECT_EQ(one.change != nullptr, are_cures) << one.name;
  }
}

TEST(DiagnosisRegistry, HasEachNameOnce) {
  for (const Hypothesis& one : hypotheses()) {
    EXPECT_EQ(find_hypothesis(one.name), &one) << one.name;
    EXPECT_FALSE(one.sentence.empty()) << one.name;
    const int functions = (one.predict != nullptr ? 1 : 0) + (one.recognise != nullptr ? 1 : 0) +
                          (one.change != nullptr ? 1 : 0) + (one.measure != nullptr ? 1 : 0);
    EXPECT_EQ(functions, 1) << one.name;
  }
  EXPECT_EQ(find_hypothesis("no such thing"), nullptr);
}

}  // namespace
}  // namespace rayproof
