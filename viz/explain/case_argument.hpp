#pragma once
/// \file
/// The CASE of a command line: a file, standard input, the case itself, or a finding of `rayproof check`, by
/// its number or as its line.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>

#include "case/case.hpp"
#include "case/files.hpp"
#include "case/findings_file.hpp"
#include "case/json/text.hpp"
#include "case/reader.hpp"
#include "case/reader/field.hpp"
#include "case/shape_format.hpp"
#include "subjects/command.hpp"

namespace rayproof::viz {

struct CaseArgument {
  Case one;
  std::string method{};     ///< "sphere/textbook" where the case came in a finding; else empty
  std::string command{};    ///< the shell line where the finding's subject is a program
  bool is_answered = true;  ///< false of a finding that the program gave no answer
  /// How long that may be silent.
  std::chrono::milliseconds case_time{usual_case_time};
};

[[nodiscard]] inline bool is_one_json_text(const std::string& text) {
  try {
    (void)json::parse(text);
    return true;
  } catch (const Refusal&) {
    return false;
  }
}

[[nodiscard]] inline std::string read_all(const std::string& file) {
  if (file == "-") return whole_text(std::cin, "standard input");
  std::ifstream in(file, std::ios::binary);
  if (!is_readable(in, file)) throw UnreadableCase(fmt::format("the file {} can't be read", file));
  return whole_text(in, file);
}

/// The text a CASE stands for: the argument itself where it begins with a brace; where it is a number, the
/// finding of that number in the file or folder `findings`; else the file's line `line`, from 1 as an editor
/// counts; without one, its one JSON text, or its first line that is not blank. Throws UnreadableCase.
[[nodiscard]] inline std::string text_of_case(const std::string& argument,
                                              std::optional<std::size_t> line = {},
                                              const std::string& findings = last_findings) {
  if (const auto number = finding_number(argument)) return finding_line(findings, *number);
  const std::size_t first = argument.find_first_not_of(" \t\r\n");
  if (first != std::string::npos && argument[first] == '{') return argument;
  const std::string text = read_all(argument);
  if (!line && is_one_json_text(text)) return text;
  const std::vector<std::string> lines = lines_in(text);
  const auto first_case = std::ranges::find_if_not(lines, is_blank);
  const std::string file = argument == "-" ? "standard input" : argument;
  if (first_case == lines.end()) throw UnreadableCase(fmt::format("{} holds no case", file));
  if (!line) return *first_case;
  if (*line > lines.size())
    throw UnreadableCase(fmt::format("{} has no line {}, only {}", file, *line, lines.size()));
  if (is_blank(lines[*line - 1])) throw UnreadableCase(fmt::format("line {} of {} is blank", *line, file));
  return lines[*line - 1];
}

/// The case, or the finding's, in its own precision or in the one given. Throws a Refusal.
[[nodiscard]] inline CaseArgument read_case_argument(std::string_view text,
                                                     std::optional<Precision> precision = {}) {
  const json::Document document = json::parse(text);
  const Field whole{.document = &document};
  ObjectReader members(whole);
  CaseArgument result;
  const auto finding = members.find("case");
  if (finding) {
    const auto subject = members.find("subject");
    result.method = subject ? read_string(*subject)
                            : read_string(members.need("shape")) + "/" + read_string(members.need("method"));
    if (const auto command = members.find("command")) result.command = read_string(*command);
    if (const auto seconds = members.find("case_seconds"))
      result.case_time =
          std::chrono::milliseconds(std::llround(1000 * read_number(*seconds, Precision::float64)));
    if (const auto got = members.find("got"); got && got->node().kind == json::Kind::object)
      result.is_answered = !ObjectReader(*got).find("error");
    text = finding->node().text;
  }
  result.one = read_case(text, precision);
  return result;
}

}  // namespace rayproof::viz
