#include "case/findings_file.hpp"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <sstream>

#include "case/files.hpp"

namespace rayproof {

std::optional<std::size_t> finding_number(const std::string& text) {
  std::size_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc{} || stop != end || number == 0) return std::nullopt;
  return number;
}

std::vector<std::string> lines_in(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

bool is_blank(const std::string& line) { return line.find_first_not_of(" \t\r") == std::string::npos; }

std::string findings_named(const std::string& from) {
  std::error_code error;
  const std::filesystem::path path(from);
  return std::filesystem::is_directory(path, error) ? (path / "findings.jsonl").string() : from;
}

std::string finding_line(const std::string& from, std::size_t number) {
  const std::string file = findings_named(from);
  std::ifstream in(file, std::ios::binary);
  if (!is_readable(in, file)) {
    throw UnreadableCase(fmt::format(
        "there is no finding {}: {} can't be read; rayproof check writes it, --from names another run's file",
        number, file));
  }
  std::vector<std::string> lines = lines_in(whole_text(in, file));
  if (number > lines.size())
    throw UnreadableCase(fmt::format("there is no finding {}: {} holds {}", number, file, lines.size()));
  if (is_blank(lines[number - 1]))
    throw UnreadableCase(fmt::format("there is no finding {}: that line of {} is blank", number, file));
  return std::move(lines[number - 1]);
}

}  // namespace rayproof
