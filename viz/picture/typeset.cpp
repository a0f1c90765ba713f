#include <string_view>

#include "viz/picture/picture.hpp"

namespace rayproof::viz {

std::string typeset(const std::string& text) {
  constexpr std::string_view before = " (,=|/^";
  std::string set;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_free = i == 0 || before.find(text[i - 1]) != std::string_view::npos || set.ends_with("·");
    const char next = i + 1 < text.size() ? text[i + 1] : ' ';
    const bool is_operator = next != ' ' || (i > 0 && text[i - 1] == ' ');
    if (text[i] == '-' && next != '-' && is_free && is_operator)
      set += "−";
    else
      set += text[i];
  }
  return set;
}

}  // namespace rayproof::viz
