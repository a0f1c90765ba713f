#pragma once
/// \file
/// The tokens of JSON: walks over a text and refuses what the grammar does not have.

#include <fmt/format.h>

#include <charconv>
#include <cstddef>
#include <string_view>

#include "case/json/text.hpp"
#include "case/shape_format.hpp"

namespace rayproof::json {

inline constexpr bool is_digit(char c) { return '0' <= c && c <= '9'; }
inline constexpr bool is_high_surrogate(unsigned code) { return 0xD800 <= code && code < 0xDC00; }
inline constexpr bool is_low_surrogate(unsigned code) { return 0xDC00 <= code && code < 0xE000; }

inline constexpr unsigned no_code = 0x10000;

/// The code of an escape like \u00e9 at the start of `text`; `no_code` where there is none.
inline unsigned unicode_escape(std::string_view text) {
  constexpr std::size_t length = 6;
  if (text.size() < length || !text.starts_with("\\u")) return no_code;
  unsigned code = 0;
  const char* const end = text.data() + length;
  return std::from_chars(text.data() + 2, end, code, 16).ptr == end ? code : no_code;
}

/// The length in bytes of the UTF-8 character at the start of `text`; 0 where there is none (overlong forms,
/// surrogates and everything above U+10FFFF are not UTF-8).
inline std::size_t utf8_length(std::string_view text) {
  const auto byte = [text](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
  };
  const auto is_tail = [byte](std::size_t i) { return (byte(i) & 0xC0U) == 0x80; };
  const unsigned lead = byte(0);
  if (lead < 0x80) return text.empty() ? 0 : 1;
  if (lead < 0xC2) return 0;  // a tail, or an overlong form of ASCII
  if (lead < 0xE0) return is_tail(1) ? 2 : 0;
  if (lead < 0xF0) {
    const bool is_overlong = lead == 0xE0 && byte(1) < 0xA0;
    const bool is_surrogate = lead == 0xED && byte(1) >= 0xA0;
    return is_tail(1) && is_tail(2) && !is_overlong && !is_surrogate ? 3 : 0;
  }
  const bool is_overlong = lead == 0xF0 && byte(1) < 0x90;
  const bool is_too_large = lead > 0xF4 || (lead == 0xF4 && byte(1) >= 0x90);
  return is_tail(1) && is_tail(2) && is_tail(3) && !is_overlong && !is_too_large ? 4 : 0;
}

/// A position in a text. Every `skip_...` passes over one token or throws a Refusal.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  [[nodiscard]] std::size_t position() const { return position_; }
  [[nodiscard]] bool at_end() const { return position_ == text_.size(); }

  void skip(std::size_t bytes) { position_ += bytes; }

  void skip_blanks() {
    while (next() == ' ' || next() == '\t' || next() == '\r' || next() == '\n') ++position_;
  }

  /// Passes over `c` if it is next, and says whether it was.
  bool take(char c) {
    if (at_end() || text_[position_] != c) return false;
    ++position_;
    return true;
  }

  /// What kind of value begins here.
  [[nodiscard]] Kind kind_of_next() const {
    const char c = next();
    if (c == '{') return Kind::object;
    if (c == '[') return Kind::array;
    if (c == '"') return Kind::string;
    if (c == 't' || c == 'f') return Kind::boolean;
    if (c == 'n') return Kind::null;
    if (c != '-' && !is_digit(c)) refuse("a value");
    return Kind::number;
  }

  /// Passes over a null, boolean, number or string.
  void skip_scalar(Kind kind) {
    if (kind == Kind::string) return skip_string("a string");
    if (kind == Kind::number) return skip_number();
    skip_word(next() == 'n' ? "null" : next() == 't' ? "true" : "false");
  }

  void skip_string(const char* expected) {
    if (!take('"')) refuse(expected);
    while (!take('"')) {
      if (at_end()) refuse("the closing '\"'");
      const auto c = static_cast<unsigned char>(text_[position_]);
      if (c == '\\') {
        skip_escape();
      } else if (c < 0x20) {
        refuse("an escape in place of a control character");
      } else {
        const std::size_t length = c < 0x80 ? 1 : utf8_length(text_.substr(position_));
        if (length == 0) refuse("valid UTF-8");
        position_ += length;
      }
    }
  }

  /// Throws the Refusal that says what should have come here.
  [[noreturn]] void refuse(const char* expected) const {
    throw Refusal("line",
                  fmt::format("the line is not JSON: expected {} at byte {}", expected, position_ + 1));
  }

 private:
  [[nodiscard]] char next() const { return at_end() ? '\0' : text_[position_]; }

  void skip_word(std::string_view word) {
    if (text_.substr(position_, word.size()) != word) refuse("a value");
    position_ += word.size();
  }

  void skip_number() {
    take('-');
    if (!take('0')) skip_digits();  // a number does not begin with 00
    if (take('.')) skip_digits();
    if (take('e') || take('E')) {
      if (!take('+')) take('-');
      skip_digits();
    }
  }

  void skip_digits() {
    if (!is_digit(next())) refuse("a digit");
    while (is_digit(next())) ++position_;
  }

  void skip_escape() {
    const std::string_view rest = text_.substr(position_);
    const bool is_short =
        rest.size() > 1 && std::string_view("\"\\/bfnrt").find(rest[1]) != std::string_view::npos;
    if (is_short) return skip(2);
    const unsigned code = unicode_escape(rest);
    if (code == no_code) refuse("a valid escape");
    if (is_low_surrogate(code)) refuse("the first half of a surrogate pair");
    if (!is_high_surrogate(code)) return skip(6);
    if (!is_low_surrogate(unicode_escape(rest.substr(6)))) refuse("both halves of a surrogate pair");
    skip(12);
  }

  std::string_view text_;
  std::size_t position_ = 0;
};

}  // namespace rayproof::json
