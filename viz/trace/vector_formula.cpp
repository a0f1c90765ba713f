#include "viz/trace/vector_formula.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace rayproof::viz {
namespace {

/// The parts between separators that stand outside of all parentheses.
std::vector<std::string> split_outside(const std::string& text, std::string_view separator) {
  std::vector<std::string> parts{""};
  int depth = 0;
  for (std::size_t i = 0; i < text.size();) {
    if (depth == 0 && text.compare(i, separator.size(), separator) == 0) {
      parts.emplace_back();
      i += separator.size();
      continue;
    }
    depth += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
    parts.back() += text[i++];
  }
  return parts;
}

std::string without(std::string text, std::string_view part) {
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at)) {
    text.erase(at, part.size());
  }
  return text;
}

constexpr std::array<const char*, 3> axes{".x", ".y", ".z"};

std::string componentwise(const std::vector<std::string>& components) {
  const std::string first = without(components[0], axes[0]);
  for (std::size_t i = 1; i < components.size(); ++i) {
    if (without(components[i], axes[i]) != first) return {};
  }
  return first == components[0] ? std::string() : first;
}

/// "a × b" of "a.y·b.z − a.z·b.y", the x component; the other two are taken on trust where they have its
/// shape.
std::string cross_product(const std::vector<std::string>& components) {
  if (components.size() != 3) return {};
  std::string result;
  for (std::size_t i = 0; i < 3; ++i) {
    const char* const y = axes[(i + 1) % 3];
    const char* const z = axes[(i + 2) % 3];
    const auto terms = split_outside(components[i], " − ");
    if (terms.size() != 2) return {};
    const auto plus = split_outside(terms[0], "·");
    const auto minus = split_outside(terms[1], "·");
    if (plus.size() != 2 || minus.size() != 2) return {};
    const std::string a = without(plus[0], y);
    const std::string b = without(plus[1], z);
    if (a == plus[0] || b == plus[1] || without(minus[0], z) != a || without(minus[1], y) != b) return {};
    const std::string both = fmt::format("{} × {}", a, b);
    if (i > 0 && both != result) return {};
    result = both;
  }
  return result;
}

bool is_part_of_name(const std::string& text, std::size_t i) {
  static constexpr std::array<std::string_view, 7> operator_signs{"·", "×", "−", "√", "⁺", "∞", "→"};
  const auto byte = static_cast<unsigned char>(text[i]);
  if (byte < 0x80) return (std::isalnum(byte) != 0) || text[i] == '_' || text[i] == '.';
  return std::none_of(operator_signs.begin(), operator_signs.end(), [&](std::string_view sign) {
    for (std::size_t back = 0; back < sign.size() && back <= i; ++back) {
      if (text.compare(i - back, sign.size(), sign) == 0) return true;
    }
    return false;
  });
}

}  // namespace

std::string vector_formula(const std::vector<std::string>& components) {
  if (components.size() < 2 || components[0].empty()) return {};
  const std::string plain = componentwise(components);
  return plain.empty() ? cross_product(components) : plain;
}

std::string put_in(const std::string& formula,
                   const std::function<std::string(const std::string& name)>& number_of) {
  std::string result;
  std::string word;
  const auto finish = [&] {
    const std::string number = word.empty() ? word : number_of(word);
    result += number.empty() ? word : number;
    word.clear();
  };
  for (std::size_t i = 0; i < formula.size(); ++i) {
    if (is_part_of_name(formula, i)) {
      word += formula[i];
    } else {
      finish();
      result += formula[i];
    }
  }
  finish();
  return result;
}

}  // namespace rayproof::viz
