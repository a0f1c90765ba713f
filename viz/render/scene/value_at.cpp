#include "viz/render/scene/value_at.hpp"

#include <fmt/format.h>

namespace rayproof::render {
namespace {

using json::Document;
using json::Kind;

/// Whether a path goes through a node's own, or ends there.
bool goes_through(std::string_view path, std::string_view own) {
  return path.starts_with(own) &&
         (path.size() == own.size() || path[own.size()] == '.' || path[own.size()] == '[');
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
  std::size_t at = 0;
  std::string here;
  while (here != path) {
    const std::size_t container = at;
    std::size_t position = 0;
    std::string next;
    // Of several members of one name the last, as the reader has it.
    for (std::size_t child = container + 1; child < document[container].end; child = document[child].end) {
      std::string own = here;
      if (document[container].kind == Kind::object)
        json::append_member(own, json::unquote(document[child].key));
      else
        own += fmt::format("[{}]", position++);
      if (!goes_through(path, own)) continue;
      at = child;
      next = own;
    }
    if (at == container) return "";
    here = next;
  }
  return document[at].kind == Kind::object ? "" : shortened(document[at].text);
}

}  // namespace rayproof::render
