#include "case/json/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <clocale>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <limits>

namespace rayproof {
namespace {

/// Where a number's text lies in the two notations: what from_chars gets, and how it reads it.
struct Digits {
  std::string_view text;
  std::chars_format format;
};

/// Checks that `text` is digits, a point, digits and an exponent, with a digit on at least one side of the
/// point. from_chars alone would read "1e" as 1, and "inf", "infinity" and "nan(1)" as well.
bool is_spelled_right(const Digits& digits) {
  const bool is_hex = digits.format == std::chars_format::hex;
  std::string_view rest = digits.text;
  const auto skip_any_of = [&rest](std::string_view characters) {
    const std::size_t count = std::min(rest.find_first_not_of(characters), rest.size());
    rest.remove_prefix(count);
    return count;
  };
  const auto take_one_of = [&rest](std::string_view characters) {
    const bool taken = !rest.empty() && characters.find(rest[0]) != std::string_view::npos;
    if (taken) rest.remove_prefix(1);
    return taken;
  };
  const std::string_view digit = is_hex ? "0123456789abcdefABCDEF" : "0123456789";
  std::size_t count = skip_any_of(digit);
  if (take_one_of(".")) count += skip_any_of(digit);
  if (count == 0) return false;
  if (take_one_of(is_hex ? "pP" : "eE")) {
    take_one_of("+-");
    if (skip_any_of("0123456789") == 0) return false;
  }
  return rest.empty();
}

/// The number where from_chars only says that it is out of range: 0 or infinity, or nearly so.
double beyond_range(const Digits& digits) {
  static const locale_t c_locale = newlocale(LC_ALL_MASK, "C", nullptr);
  const std::string text = (digits.format == std::chars_format::hex ? "0x" : "") + std::string(digits.text);
  return strtod_l(text.c_str(), nullptr, c_locale);
}

template <class X>
void append_shortest(std::string& out, X x) {
  if (std::isnan(x)) {
    out += "\"nan\"";
  } else if (std::isinf(x)) {
    out += x > 0 ? "\"inf\"" : "\"-inf\"";
  } else if (x == 0) {
    out += std::signbit(x) ? "-0.0" : "0";
  } else {
    fmt::format_to(std::back_inserter(out), "{}", x);
  }
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  if (text == "inf") return std::numeric_limits<double>::infinity();
  if (text == "-inf") return -std::numeric_limits<double>::infinity();
  if (text == "nan") return std::numeric_limits<double>::quiet_NaN();

  const double sign = text.starts_with('-') ? -1 : 1;
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  const bool is_hex = text.starts_with("0x") || text.starts_with("0X");
  if (is_hex) text.remove_prefix(2);

  const Digits digits{text, is_hex ? std::chars_format::hex : std::chars_format::general};
  if (!is_spelled_right(digits)) return std::nullopt;
  double magnitude = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), magnitude, digits.format);
  if (read.ec == std::errc::result_out_of_range) magnitude = beyond_range(digits);
  return sign * magnitude;
}

std::string_view case_spelling(std::string_view text) {
  const bool is_negative = text.starts_with('-');
  if (is_negative || text.starts_with('+')) text.remove_prefix(1);
  const auto is_word = [text](std::string_view word) {
    return std::equal(text.begin(), text.end(), word.begin(), word.end(),
                      [](char a, char b) { return (a | 0x20) == b; });  // the letter in lower case
  };
  if (is_word("inf") || is_word("infinity")) return is_negative ? "-inf" : "inf";
  return is_word("nan") ? "nan" : "";
}

double round_to(Precision precision, double x) {
  return precision == Precision::float32 ? static_cast<double>(static_cast<float>(x)) : x;
}

void append_number(std::string& out, double x) { append_shortest(out, x); }

void append_number(std::string& out, double x, Precision precision) {
  const std::size_t start = out.size();
  if (precision == Precision::float32 && std::abs(x) <= std::numeric_limits<float>::max()) {
    append_shortest(out, static_cast<float>(x));
    // A case's number is rounded twice, to double and then to float, which a decimal next to a tie may not
    // survive.
    const std::optional<double> read = parse_number(std::string_view(out).substr(start));
    if (read && round_to(precision, *read) == x) return;
    out.resize(start);
  }
  append_shortest(out, x);
}

void append_hex(std::string& out, double x) {
  if (!std::isfinite(x)) return append_shortest(out, x);
  out += std::signbit(x) ? "\"-0x" : "\"0x";
  std::array<char, 32> digits{};
  const auto written =
      std::to_chars(digits.data(), digits.data() + digits.size(), std::abs(x), std::chars_format::hex);
  out.append(digits.data(), written.ptr);
  out += '"';
}

}  // namespace rayproof
