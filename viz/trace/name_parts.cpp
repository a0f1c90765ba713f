#include "viz/trace/name_parts.hpp"

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
  for (const auto& [sign, plain] : subscripts) {
    if (name.size() <= sign.size() || !name.ends_with(sign)) continue;
    parts.index = plain + parts.index;
    name.erase(name.size() - sign.size());
  }
  const std::size_t arrow = name.find(arrow_above);
  parts.has_arrow = arrow != std::string::npos;
  if (parts.has_arrow) name.erase(arrow, arrow_above.size());
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
