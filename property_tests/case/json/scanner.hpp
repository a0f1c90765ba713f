#pragma once
/// \file
/// The tokens of JSON: walks over a text and refuses what the grammar does not have.

#include <cstddef>
#include <string_view>

#include "case/json/text.hpp"

namespace rayproof::json {

/// A position in a text. Every `skip_...` passes over one token or throws a Refusal.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  [[nodiscard]] std::size_t position() const { return position_; }
  [[nodiscard]] bool at_end() const { return position_ == text_.size(); }

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
