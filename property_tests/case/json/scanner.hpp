#pragma once
/// \file
/// The tokens of JSON: walks over a text and refuses what the grammar does not have.

#include <cstddef>
#include <string_view>

#include "case/json/text.hpp"

namespace rayproof::json {

[[nodiscard]] constexpr bool is_digit(char c) { return '0' <= c && c <= '9'; }
[[nodiscard]] constexpr bool is_high_surrogate(unsigned code) { return 0xD800 <= code && code < 0xDC00; }
[[nodiscard]] constexpr bool is_low_surrogate(unsigned code) { return 0xDC00 <= code && code < 0xE000; }

/// The number that four hex digits stand for; above 0xFFFF where they are not four hex digits.
[[nodiscard]] unsigned hex4(std::string_view digits);

/// The length in bytes of the UTF-8 character at the start of `text`; 0 where there is none (overlong forms,
/// surrogates and everything above U+10FFFF are not UTF-8).
[[nodiscard]] std::size_t utf8_length(std::string_view text);

/// A position in a text. Every `skip_...` passes over one token or throws a Refusal.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  [[nodiscard]] std::size_t position() const { return position_; }
  [[nodiscard]] bool at_end() const { return position_ == text_.size(); }
  [[nodiscard]] std::string_view text_from(std::size_t start) const {
    return text_.substr(start, position_ - start);
  }

  void skip(std::size_t bytes) { position_ += bytes; }
  void skip_blanks();

  /// Passes over `c` if it is next, and says whether it was.
  bool take(char c);

  /// What kind of value begins here.
  [[nodiscard]] Kind kind_of_next() const;

  /// Passes over a null, boolean, number or string.
  void skip_scalar(Kind kind);
  void skip_string(const char* expected);

  /// Throws the Refusal that says what should have come here.
  [[noreturn]] void refuse(const char* expected) const;

 private:
  [[nodiscard]] char next() const { return at_end() ? '\0' : text_[position_]; }
  void skip_word(std::string_view word);
  void skip_number();
  void skip_digits();
  void skip_escape();

  std::string_view text_;
  std::size_t position_ = 0;
};

}  // namespace rayproof::json
