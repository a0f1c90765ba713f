#pragma once
/// \file
/// The members of a JSON object on a line that is known to be valid: views into the line, nothing copied.
///
/// A program on trial is sent valid cases alone and must read them quickly; whoever has to refuse a line, and
/// say why, reads it by `read_case`.

#include <array>
#include <cstddef>
#include <string_view>

namespace rayproof::answering {

/// What a byte of a JSON text is, outside of strings.
enum class Byte : unsigned char { of_value, quote, opening, closing, filler };

inline constexpr std::array<Byte, 256> bytes = [] {
  std::array<Byte, 256> kinds{};
  kinds['"'] = Byte::quote;
  kinds['{'] = kinds['['] = Byte::opening;
  kinds['}'] = kinds[']'] = Byte::closing;
  for (const unsigned char c : {' ', ',', ':', '\t', '\r', '\n'}) kinds[c] = Byte::filler;
  return kinds;
}();

/// Walks over the values of a JSON text. On a text that is not JSON it stops early, and never reads beyond.
class Walker {
 public:
  explicit Walker(std::string_view text) : rest_(text) {}

  /// Passes over blanks, commas, colons and `bracket`s, which say nothing that their values do not.
  void enter(char bracket) {
    skip_filler();
    if (!rest_.empty() && rest_.front() == bracket) rest_.remove_prefix(1);
  }

  /// The next value as it stands in the text; empty at the end of the object or array.
  [[nodiscard]] std::string_view next() {
    skip_filler();
    if (rest_.empty() || rest_.front() == '}' || rest_.front() == ']') return {};
    const std::size_t length = length_of_value();
    const std::string_view value = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return value;
  }

 private:
  [[nodiscard]] Byte byte_at(std::size_t i) const { return bytes[static_cast<unsigned char>(rest_[i])]; }

  void skip_filler() {
    std::size_t i = 0;
    while (i < rest_.size() && byte_at(i) == Byte::filler) ++i;
    rest_.remove_prefix(i);
  }

  /// The place after the string that begins at `i`.
  [[nodiscard]] std::size_t end_of_string(std::size_t i) const {
    for (++i; i < rest_.size() && rest_[i] != '"'; ++i)
      if (rest_[i] == '\\') ++i;
    return i < rest_.size() ? i + 1 : rest_.size();
  }

  [[nodiscard]] std::size_t length_of_value() const {
    if (rest_.front() == '"') return end_of_string(0);
    if (byte_at(0) == Byte::opening) return length_of_nested();
    std::size_t i = 0;
    while (i < rest_.size() && byte_at(i) == Byte::of_value) ++i;
    return i;
  }

  /// Of the object or array that begins here.
  [[nodiscard]] std::size_t length_of_nested() const {
    std::size_t depth = 0;
    for (std::size_t i = 0; i < rest_.size(); ++i) {
      switch (byte_at(i)) {
        case Byte::of_value:
        case Byte::filler:
          break;
        case Byte::quote:
          i = end_of_string(i) - 1;
          break;
        case Byte::opening:
          ++depth;
          break;
        case Byte::closing:
          if (--depth == 0) return i + 1;
      }
    }
    return rest_.size();
  }

  std::string_view rest_;
};

/// Calls `act(name, value)` for each member of a JSON object; names and strings without their quotes.
void each_member(std::string_view object, auto&& act) {
  Walker walker(object);
  walker.enter('{');
  for (std::string_view name = walker.next(); name.size() >= 2; name = walker.next())
    act(name.substr(1, name.size() - 2), walker.next());
}

/// Calls `act(value)` for each element of a JSON array.
void each_value(std::string_view array, auto&& act) {
  Walker walker(array);
  walker.enter('[');
  for (std::string_view value = walker.next(); !value.empty(); value = walker.next()) act(value);
}

/// A string without its quotes (its escapes stay), any other value as it is.
[[nodiscard]] inline std::string_view unquoted(std::string_view value) {
  const bool is_string = value.size() >= 2 && value.front() == '"';
  return is_string ? value.substr(1, value.size() - 2) : value;
}

}  // namespace rayproof::answering
