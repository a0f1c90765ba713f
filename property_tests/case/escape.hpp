#pragma once
#include <array>
#include <string>
#include <string_view>

namespace rayproof {

/// The text as it stands in XML or HTML, between tags or within quotes. What XML cannot hold becomes a
/// question mark.
[[nodiscard]] inline std::string escaped(std::string_view text) {
  constexpr std::string_view marks = "<>&\"'";
  constexpr std::array entities{"&lt;", "&gt;", "&amp;", "&quot;", "&#39;"};
  std::string result;
  for (const char letter : text) {
    const std::size_t mark = marks.find(letter);
    const bool is_allowed = static_cast<unsigned char>(letter) >= 0x20 || letter == '\n' || letter == '\t';
    if (mark < entities.size()) {
      result += entities.at(mark);
    } else {
      result += is_allowed ? letter : '?';
    }
  }
  return result;
}

}  // namespace rayproof
