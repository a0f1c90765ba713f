#pragma once
/// \file
/// The tokens of JSON: walks over a text and refuses what the grammar does not have.

#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <cstddef>
#include <string_view>

#include "case/json/text.hpp"
#include "case/shape_format.hpp"

namespace rayproof::json {

constexpr bool is_digit(char c) { return '0' <= c && c <= '9'; }
constexpr bool is_high_surrogate(unsigned code) { return 0xD800 <= code && code < 0xDC00; }
constexpr bool is_low_surrogate(unsigned code) { return 0xDC00 <= code && code < 0xE000; }

inline constexpr unsigned no_code = 0x10000;

/// The code of an escape like \u00e9 at the start of `text`; `no_code` where there is none.
inline unsigned unicode_escape(std::string_view text) {
  constexpr std::size_t length = 6;
  if (text.size() < length || !text.starts_with("\\u")) return no_code;
  unsigned code = 0;
  const char* const end = text.data() + length;
  return std::from_chars(text.data() + 2, end, code, 16).ptr == end ? code : no_code;
}

/// The length in bytes of the UTF-8 character at the start of `text`, which is not empty; 0 where there is
/// none (overlong forms, surrogates and everything above U+10FFFF are not UTF-8).
inline std::size_t utf8_length(std::string_view text) {
  constexpr unsigned least[] = {0, 0, 0x80, 0x800, 0x10000};
  const auto lead = static_cast<unsigned char>(text[0]);
  const auto length = static_cast<std::size_t>(std::countl_one(lead));
  if (length == 0) return 1;
  if (length == 1 || length > 4 || length > text.size()) return 0;
  unsigned code = lead & (0x7FU >> length);
  for (const char tail : text.substr(1, length - 1)) {
    if ((static_cast<unsigned char>(tail) & 0xC0U) != 0x80) return 0;
    code = code << 6U | (static_cast<unsigned char>(tail) & 0x3FU);
  }
  const bool is_surrogate = is_high_surrogate(code) || is_low_surrogate(code);
  return code >= least[length] && code <= 0x10FFFF && !is_surrogate ? length : 0;
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
