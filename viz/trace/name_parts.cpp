#include "viz/trace/name_parts.hpp"

#include <string_view>

namespace rayproof::viz {
namespace {

// Of three bytes each.
constexpr std::string_view low_signs = "₀₁₂₃₄₅₆₇₈₉ₓᵢⱼₖ";
constexpr std::string_view plain_signs = "0123456789xijk";

}  // namespace

NameParts parts_of_name(std::string name) {
  NameParts parts;
  const auto take_index = [&](std::size_t at) {
    if (at == std::string::npos || at == 0) return;
    parts.index = name.substr(at + 1) + parts.index;
    name.erase(at);
  };
  take_index(name.rfind('.'));
  take_index(name.find('_'));
  while (name.size() > 3) {
    const std::size_t sign = low_signs.find(name.substr(name.size() - 3));
    if (sign == std::string_view::npos) break;
    parts.index = plain_signs[sign / 3] + parts.index;
    name.erase(name.size() - 3);
  }
  parts.letters = name;
  return parts;
}

std::string vector_of(const std::string& name, char axis) {
  const bool is_component = name.size() > 2 && name[name.size() - 2] == '.' && name.back() == axis;
  return is_component ? name.substr(0, name.size() - 2) : "";
}

std::string without_axis(const std::string& name) {
  for (const char axis : {'x', 'y', 'z'}) {
    if (std::string vector = vector_of(name, axis); !vector.empty()) return vector;
  }
  return name;
}

}  // namespace rayproof::viz
