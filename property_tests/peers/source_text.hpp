#pragma once
/// \file
/// Numbers as a C++ program has them, and the program around a few statements.

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "answer_cases.hpp"

namespace rayproof::peers {

/// Some numbers by the name that a reproduction has for them.
template <class V>
struct Given {
  std::string_view name;
  const V& value;
};

template <class V>
[[nodiscard]] Given<V> given(std::string_view name, const V& value) {
  return {name, value};
}

/// The type of the numbers in a value: void for what is no floating-point number.
template <class V>
struct NumbersIn {
  using type = void;
};
template <std::floating_point T>
struct NumbersIn<T> {
  using type = T;
};
template <class T>
struct NumbersIn<glm::vec<3, T>> {
  using type = T;
};
template <class T>
struct NumbersIn<Vec2<T>> {
  using type = T;
};
template <class V>
struct NumbersIn<std::vector<V>> : NumbersIn<V> {};
template <class V, std::size_t extent>
struct NumbersIn<std::span<const V, extent>> : NumbersIn<V> {};
template <class V>
using NumberOf = typename NumbersIn<V>::type;

/// Every place of `name` in the text that no letter or digit follows, replaced.
[[nodiscard]] inline std::string replaced(std::string text, const std::string& name, const std::string& by) {
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at)) {
    const std::size_t end = at + name.size();
    const bool is_longer_name = end < text.size() && (std::isalnum(text[end]) != 0 || text[end] == '_');
    if (!is_longer_name) text.replace(at, name.size(), by);
    at += is_longer_name ? name.size() : by.size();
  }
  return text;
}

/// A text as JSON has it.
[[nodiscard]] inline std::string json_text(std::string_view text) {
  std::string json = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') json += '\\';
    if (c == '\n') json += "\\n";
    if (c != '\n') json += c;
  }
  return json + "\"";
}

/// The fewest digits that distinguish a number.
template <class T>
[[nodiscard]] std::string shortest(T number) {
  std::array<char, 64> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  return {digits.data(), end};
}

/// A number as a C++ literal: 0.1F is a float, 1 stands for either.
template <class T>
[[nodiscard]] std::string as_source(const T& number) requires std::is_arithmetic_v<T> {
  if constexpr (std::floating_point<T>) {
    if (std::isinf(number)) return number < 0 ? "-INFINITY" : "INFINITY";
    std::string text = number == 0 && std::signbit(number) ? "-0.0" : shortest(number);
    if (text.find_first_of(".e") == std::string::npos) return text;
    return std::is_same_v<T, float> ? text + "F" : text;
  } else {
    return std::to_string(number);
  }
}
[[nodiscard]] inline std::string as_source(const std::string& text) { return text; }
template <class T>
[[nodiscard]] std::string as_source(const glm::vec<3, T>& v) {
  return as_source(v.x) + ", " + as_source(v.y) + ", " + as_source(v.z);
}
template <class T>
[[nodiscard]] std::string as_source(const Vec2<T>& v) {
  return as_source(v.x) + ", " + as_source(v.y);
}
/// A list has braces around each of its vectors.
template <class List>
[[nodiscard]] std::string as_source(const List& list) requires requires {
  list.data();
} &&(!std::is_same_v<List, std::string>) {
  std::string text;
  for (const auto& one : list) text += (text.empty() ? "{" : ", {") + as_source(one) + "}";
  return text;
}

/// The same as JSON; infinities are strings.
template <class V>
[[nodiscard]] std::string as_json(const V& value) {
  if constexpr (std::floating_point<V>) {
    // As a double, whose digits say a float's value exactly.
    const auto wide = static_cast<double>(value);
    return std::isfinite(wide) ? shortest(wide) : json_text(shortest(wide));
  } else if constexpr (std::is_arithmetic_v<V>) {
    return std::to_string(value);
  } else if constexpr (std::is_same_v<V, std::string>) {
    return json_text(value);
  } else if constexpr (requires { value.data(); }) {
    std::string text;
    for (const auto& one : value) text += (text.empty() ? "" : ", ") + as_json(one);
    return "[" + text + "]";
  } else if constexpr (requires { value.z; }) {
    return "[" + as_json(value.x) + ", " + as_json(value.y) + ", " + as_json(value.z) + "]";
  } else {
    return "[" + as_json(value.x) + ", " + as_json(value.y) + "]";
  }
}

/// A number as the reproduction prints it: %d, or %.9g of a float and %.17g of a double.
template <class V>
[[nodiscard]] std::string as_printed(const V& value) {
  if constexpr (std::floating_point<V>) {
    std::array<char, 64> digits{};
    if constexpr (std::is_same_v<V, float>) {
      std::snprintf(digits.data(), digits.size(), "%.9g", static_cast<double>(value));
    } else {
      std::snprintf(digits.data(), digits.size(), "%.17g", value);
    }
    return digits.data();
  } else {
    return std::to_string(value);
  }
}

/// The whole program: what belongs before main, and the statements in it.
[[nodiscard]] inline std::string program_of(const std::string& body) {
  std::string before, within;
  std::istringstream lines(body);
  for (std::string line; std::getline(lines, line);) {
    const std::string bare = line.substr(std::min(line.find_first_not_of(' '), line.size()));
    if (bare.empty()) continue;
    const bool is_before =
        bare.starts_with('#') || bare.starts_with("namespace") || bare.starts_with("using ");
    // The same header may be asked for by several parts.
    if (is_before && before.find(bare + "\n") != std::string::npos) continue;
    (is_before ? before : within) += (is_before ? "" : "  ") + bare + "\n";
  }
  if (within.find("INFINITY") != std::string::npos) before += "#include <cmath>\n";
  // Headers first, then what uses them.
  const std::size_t last = before.rfind("#include");
  const std::size_t end = last == std::string::npos ? 0 : before.find('\n', last) + 1;
  return before.substr(0, end) + "#include <cstdio>\n" + before.substr(end) + "int main() {\n" + within +
         "}\n";
}

}  // namespace rayproof::peers
