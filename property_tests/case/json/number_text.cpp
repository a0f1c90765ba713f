#include "case/json/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <clocale>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <limits>

namespace rayproof {
namespace {

/// The number where from_chars only says that it is out of range: 0 or infinity, or nearly so.
double beyond_range(std::string_view digits, bool is_hex) {
  static const locale_t c_locale = newlocale(LC_ALL_MASK, "C", nullptr);
  const std::string text = (is_hex ? "0x" : "") + std::string(digits);
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

  // from_chars would also read "infinity" and "nan(1)", and libstdc++ 12 the exponent +-1 of a hex float.
  const std::string_view first_characters = is_hex ? ".0123456789abcdefABCDEF" : ".0123456789";
  if (text.empty() || first_characters.find(text[0]) == std::string_view::npos) return std::nullopt;
  if (text.find("+-") != std::string_view::npos) return std::nullopt;
  double magnitude = 0;
  const auto format = is_hex ? std::chars_format::hex : std::chars_format::general;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), magnitude, format);
  if (read.ec == std::errc::invalid_argument || read.ptr != text.data() + text.size()) return std::nullopt;
  if (read.ec == std::errc::result_out_of_range) magnitude = beyond_range(text, is_hex);
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
  fmt::format_to(std::back_inserter(out), "\"{:a}\"", x);
}

}  // namespace rayproof
