#pragma once
/// \file
/// Reads a number of the case format; the standard library alone, for the headers of `answer_cases`, too.

#include <charconv>
#include <clocale>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace rayproof {

namespace detail {

/// The number where from_chars only says that it is out of range: 0 or infinity, or nearly so.
inline double beyond_range(std::string_view digits, bool is_hex) {
  static const locale_t c_locale = newlocale(LC_ALL_MASK, "C", nullptr);
  const std::string text = (is_hex ? "0x" : "") + std::string(digits);
  return strtod_l(text.c_str(), nullptr, c_locale);
}

}  // namespace detail

/// The double nearest to a decimal (`-12.5e3`) or a C hex float (`-0x1.8p+1`), ties to even; infinite where
/// it overflows. Also reads "inf", "-inf" and "nan". Nothing for any other text: blanks, "infinity", "+inf",
/// "1e".
[[nodiscard]] inline std::optional<double> parse_number(std::string_view text) {
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
  if (read.ec == std::errc::result_out_of_range) magnitude = detail::beyond_range(text, is_hex);
  return sign * magnitude;
}

}  // namespace rayproof
