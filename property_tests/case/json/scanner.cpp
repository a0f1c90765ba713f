#include "case/json/scanner.hpp"

#include <fmt/format.h>

#include <charconv>

#include "case/shape_format.hpp"

namespace rayproof::json {

unsigned hex4(std::string_view digits) {
  unsigned code = 0;
  const char* const end = digits.data() + digits.size();
  const auto read = std::from_chars(digits.data(), end, code, 16);
  return digits.size() == 4 && read.ec == std::errc{} && read.ptr == end ? code : 0x10000;
}

std::size_t utf8_length(std::string_view text) {
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

void Scanner::refuse(const char* expected) const {
  throw Refusal("line", fmt::format("the line is not JSON: expected {} at byte {}", expected, position_ + 1));
}

void Scanner::skip_blanks() {
  while (next() == ' ' || next() == '\t' || next() == '\r' || next() == '\n') ++position_;
}

bool Scanner::take(char c) {
  if (at_end() || text_[position_] != c) return false;
  ++position_;
  return true;
}

Kind Scanner::kind_of_next() const {
  switch (next()) {
    case '{':
      return Kind::object;
    case '[':
      return Kind::array;
    case '"':
      return Kind::string;
    case 't':
    case 'f':
      return Kind::boolean;
    case 'n':
      return Kind::null;
    default:
      break;
  }
  if (next() != '-' && !is_digit(next())) refuse("a value");
  return Kind::number;
}

void Scanner::skip_scalar(Kind kind) {
  switch (kind) {
    case Kind::string:
      return skip_string("a string");
    case Kind::number:
      return skip_number();
    case Kind::null:
      return skip_word("null");
    default:
      return skip_word(next() == 't' ? "true" : "false");
  }
}

void Scanner::skip_word(std::string_view word) {
  if (text_.substr(position_, word.size()) != word) refuse("a value");
  position_ += word.size();
}

void Scanner::skip_number() {
  take('-');
  if (!take('0')) skip_digits();  // a number does not begin with 00
  if (take('.')) skip_digits();
  if (take('e') || take('E')) {
    if (!take('+')) take('-');
    skip_digits();
  }
}

void Scanner::skip_digits() {
  if (!is_digit(next())) refuse("a digit");
  while (is_digit(next())) ++position_;
}

void Scanner::skip_string(const char* expected) {
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

void Scanner::skip_escape() {
  constexpr std::string_view one_letter = "\"\\/bfnrt";
  const auto code_at = [this](std::size_t i) {
    const std::string_view rest = text_.substr(position_, 12);
    return rest.size() > i && rest.substr(i, 2) == "\\u" ? hex4(rest.substr(i + 2, 4)) : 0x10000U;
  };
  if (position_ + 1 < text_.size() && one_letter.find(text_[position_ + 1]) != std::string_view::npos) {
    position_ += 2;
    return;
  }
  const unsigned code = code_at(0);
  if (code > 0xFFFF) refuse("a valid escape");
  if (is_low_surrogate(code)) refuse("the first half of a surrogate pair");
  if (is_high_surrogate(code) && !is_low_surrogate(code_at(6))) refuse("both halves of a surrogate pair");
  position_ += is_high_surrogate(code) ? 12 : 6;
}

}  // namespace rayproof::json
