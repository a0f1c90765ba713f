#include "viz/page/math_names.hpp"
#include "case/escape.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>
#include <utility>

namespace rayproof::viz {
namespace {

constexpr std::array<std::pair<std::string_view, const char*>, 14> subscripts{{{"₀", "0"},
                                                                               {"₁", "1"},
                                                                               {"₂", "2"},
                                                                               {"₃", "3"},
                                                                               {"₄", "4"},
                                                                               {"₅", "5"},
                                                                               {"₆", "6"},
                                                                               {"₇", "7"},
                                                                               {"₈", "8"},
                                                                               {"₉", "9"},
                                                                               {"ₓ", "x"},
                                                                               {"ᵢ", "i"},
                                                                               {"ⱼ", "j"},
                                                                               {"ₖ", "k"}}};
constexpr std::string_view arrow_above = "\u20d7";

std::string identifier(const std::string& text) {
  return fmt::format("<mi{}>{}</mi>", text.size() > 1 ? " mathvariant=\"normal\"" : "", escaped(text));
}

}  // namespace

std::string typeset_name(std::string text) {
  std::string below;
  const auto take_suffix = [&](std::size_t at, std::size_t length) {
    below = escaped(text.substr(at + length)) + below;
    text.erase(at);
  };
  if (const std::size_t dot = text.rfind('.'); dot != std::string::npos && dot > 0) take_suffix(dot, 1);
  if (const std::size_t low = text.find('_'); low != std::string::npos && low > 0) take_suffix(low, 1);
  for (const auto& [sign, plain] : subscripts) {
    if (text.size() > sign.size() && text.ends_with(sign)) {
      below = plain + below;
      text.erase(text.size() - sign.size());
    }
  }
  const std::size_t arrow = text.find(arrow_above);
  if (arrow != std::string::npos) text.erase(arrow, arrow_above.size());
  std::string result = identifier(text);
  if (arrow != std::string::npos) result = fmt::format("<mover>{}<mo>→</mo></mover>", result);
  return below.empty() ? result : fmt::format("<msub>{}<mi>{}</mi></msub>", result, below);
}

}  // namespace rayproof::viz
