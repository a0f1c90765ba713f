#include "case/findings_file.hpp"

#include <fmt/format.h>

#include <charconv>
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
  for (std::string line; std::getline(in, line);)
    if (line.find_first_not_of(" \t\r") != std::string::npos) lines.push_back(line);
  return lines;
}

std::string finding_line(const std::string& file, std::size_t number) {
  std::ifstream in(file, std::ios::binary);
  if (!is_readable(in, file)) {
    throw UnreadableCase(fmt::format(
        "there is no finding {}: {} can't be read; rayproof check writes it, --from names another run's file",
        number, file));
  }
  std::vector<std::string> lines = lines_in(whole_text(in, file));
  if (number <= lines.size()) return std::move(lines[number - 1]);
  throw UnreadableCase(fmt::format("there is no finding {}: {} holds {}", number, file, lines.size()));
}

}  // namespace rayproof
