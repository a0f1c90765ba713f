#pragma once
#include <string>
#include <string_view>

namespace rayproof {

/// The text as it stands in XML or HTML, between tags or within quotes. What XML cannot hold becomes a
/// question mark.
[[nodiscard]] inline std::string escaped(std::string_view text) {
  std::string result;
  for (const char letter : text) {
    switch (letter) {
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '&':
        result += "&amp;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default: {
        const auto code = static_cast<unsigned char>(letter);
        const bool is_allowed = code >= 0x20 || letter == '\n' || letter == '\t';
        result += is_allowed ? letter : '?';
      }
    }
  }
  return result;
}

}  // namespace rayproof
