#include "viz/picture/picture.hpp"

#include <cctype>

namespace rayproof::viz {
namespace {

/// A Latin letter, a digit, or a byte of a Greek letter.
bool is_letter(const std::string& text, std::size_t i) {
  if (i >= text.size()) return false;
  const auto byte = static_cast<unsigned char>(text[i]);
  const bool continues = (byte & 0xC0U) == 0x80U && i > 0;
  const auto lead = static_cast<unsigned char>(continues ? text[i - 1] : text[i]);
  return std::isalnum(byte) != 0 || lead == 0xCE || lead == 0xCF;
}

/// Where the index ends that begins after the "_" at `low`; `low` where there is none. "cross_side" and the
/// method "sphere/half_b" have none.
std::size_t end_of_index(const std::string& line, std::size_t low) {
  std::size_t begin = low, end = low + 1;
  while (begin > 0 && is_letter(line, begin - 1)) --begin;
  while (is_letter(line, end)) ++end;
  const bool is_alone = (begin == 0 || (line[begin - 1] != '_' && line[begin - 1] != '/')) &&
                        (end == line.size() || line[end] != '_');
  const std::size_t before = low - begin, after = end - low - 1;
  const bool is_name = before > 0 && after > 0 && (before <= 2 || after == 1);
  return is_alone && is_name ? end : low;
}

}  // namespace

std::vector<TextRun> runs_of(const std::string& line) {
  std::vector<TextRun> runs{{}};
  for (std::size_t i = 0; i < line.size(); ++i) {
    const std::size_t end = line[i] == '_' ? end_of_index(line, i) : i;
    if (end == i) {
      runs.back().text += line[i];
      continue;
    }
    runs.push_back({line.substr(i + 1, end - i - 1), true});
    if (end < line.size()) runs.emplace_back();
    i = end - 1;
  }
  return runs;
}

}  // namespace rayproof::viz
