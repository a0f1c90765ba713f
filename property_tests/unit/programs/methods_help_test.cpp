/// \file
/// Whether somebody who meets `rayproof methods` for the first time can read it.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <rayproof/topics.hpp>
#include <set>
#include <sstream>

#include "unit/command.hpp"

namespace rayproof {
namespace {

std::string methods(const std::string& options) {
  return test::run(RAYPROOF_BIN_DIR "/rayproof-methods " + options).output;
}

TEST(methods_program, explains_every_term_of_its_table_and_its_listing) {
  const std::string help = methods("--help");
  const std::string table = methods("");
  std::istringstream header(table.substr(0, table.find('\n')));
  std::vector<std::string> terms{"domain", "far_power", "breaks"};  // which stand under a row
  for (std::string term; header >> term;) terms.push_back(term);
  EXPECT_EQ(terms.size(), 8U) << table.substr(0, table.find('\n'));
  for (const std::string& term : terms) {
    EXPECT_NE(table.find(term), std::string::npos) << term;
    EXPECT_NE(help.find("\n  " + term + "  "), std::string::npos) << term << " is not explained";
  }
  for (const std::string word :
       {"sound: ", "naive: ", "printed: ", "every_number means", "null is", "holds are"})
    EXPECT_NE(help.find(word), std::string::npos) << word;
}

TEST(methods_program, names_the_header_that_defines_the_units_of_each_shape) {
  const std::string help = methods("--help");
  std::set<std::string> topics;
  for (const nlohmann::json& method : nlohmann::json::parse(methods("--json")))
    topics.insert(method.at("topic").get<std::string>());
  std::size_t registered = 0;
  Topics::for_each([&](auto /*topic*/) { ++registered; });
  EXPECT_EQ(topics.size(), registered);
  for (const std::string& topic : topics) {
    const std::string header = "rayproof/" + (topic == "point_in_polygon" ? "polygon" : topic) + ".hpp";
    EXPECT_NE(help.find(header), std::string::npos) << header;
    std::ifstream file(RAYPROOF_SOURCE_DIR "/lib/include/" + header);
    const std::string text(std::istreambuf_iterator<char>(file), {});
    EXPECT_NE(text.find("Units of the contracts"), std::string::npos) << header;
  }
}

TEST(methods_program, prints_lines_that_fit_into_80_columns) {
  for (const std::string options : {"", "--help"}) {
    std::istringstream lines(methods(options));
    int count = 0;
    for (std::string line; std::getline(lines, line); ++count) {
      const auto letters = std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xC0) != 0x80; });
      EXPECT_LE(letters, 80) << line;
    }
    EXPECT_GT(count, 40) << options;
  }
}

}  // namespace
}  // namespace rayproof
