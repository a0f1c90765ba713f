#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>

#include "case/json/text.hpp"

namespace rayproof::json {

std::string unquote(std::string_view quoted) {
  const bool is_plain = quoted.find('\\') == std::string_view::npos;
  return is_plain ? std::string(quoted.substr(1, quoted.size() - 2))
                  : nlohmann::json::parse(quoted).get<std::string>();
}

std::string quote(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out.push_back('\\');
      out.push_back(c);
    } else if (static_cast<unsigned char>(c) < 0x20) {
      fmt::format_to(std::back_inserter(out), "\\u{:04x}", static_cast<unsigned>(c));
    } else {
      out.push_back(c);
    }
  }
  out.push_back('"');
  return out;
}

}  // namespace rayproof::json
