#include "viz/render/value_at.hpp"

#include <algorithm>
#include <charconv>
#include <optional>

namespace rayproof::render {
namespace {

using json::Document;
using json::Kind;

std::optional<std::size_t> member(const Document& document, std::size_t object, std::string_view name) {
  std::optional<std::size_t> found;  // the last of several, as the reader has it
  if (document[object].kind != Kind::object) return found;
  for (std::size_t i = object + 1; i < document[object].end; i = document[i].end) {
    if (json::unquote(document[i].key) == name) found = i;
  }
  return found;
}

std::optional<std::size_t> element(const Document& document, std::size_t array, std::size_t position) {
  if (document[array].kind != Kind::array) return std::nullopt;
  std::size_t i = array + 1;
  for (; i < document[array].end && position > 0; i = document[i].end) --position;
  if (i >= document[array].end) return std::nullopt;
  return i;
}

/// The part of the path before the next dot or bracket, taken off it.
std::string_view take_step(std::string_view& path) {
  const std::size_t length = std::min(path.find_first_of(".[", 1), path.size());
  const std::string_view step = path.substr(0, length);
  path.remove_prefix(length);
  return step;
}

/// The text on one line, shortened to whole characters of UTF-8.
std::string shortened(std::string_view text) {
  constexpr std::size_t longest = 60;
  std::string line;
  for (const char c : text) {
    const bool is_blank = c == ' ' || c == '\t' || c == '\r' || c == '\n';
    if (!is_blank) line += c;
    if (is_blank && !line.ends_with(' ')) line += ' ';
  }
  if (line.size() <= longest) return line;
  std::size_t end = longest;
  while (end > 0 && (static_cast<unsigned char>(line[end]) & 0xC0U) == 0x80U) --end;
  return line.substr(0, end) + "…";
}

}  // namespace

std::string value_at(const Document& document, std::string_view path) {
  if (document.empty() || path.empty()) return "";
  std::optional<std::size_t> at = 0;
  while (!path.empty() && at) {
    std::string_view step = take_step(path);
    if (step.starts_with('[')) {
      std::size_t position = 0;
      std::from_chars(step.data() + 1, step.data() + step.size(), position);
      at = element(document, *at, position);
    } else {
      if (step.starts_with('.')) step.remove_prefix(1);
      at = member(document, *at, step);
    }
  }
  return at && document[*at].kind != Kind::object ? shortened(document[*at].text) : "";
}

}  // namespace rayproof::render
