#include "case/json/number_text.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

namespace rayproof {
namespace {

/// The shortest text that reads as the number. Whole numbers below 2^24 have one digit by digit in both
/// precisions, and most numbers of a shrunk or short case are such.
template <class X>
void append_finite(std::string& out, X x) {
  if (std::abs(x) < X(0x1p24) && x == std::trunc(x)) {
    const fmt::format_int digits(static_cast<int>(x));
    out.append(digits.data(), digits.size());
    return;
  }
  std::array<char, 40> text{};
  const char* const end = fmt::format_to(text.data(), FMT_COMPILE("{}"), x);
  out.append(static_cast<const char*>(text.data()), end);
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
    append_finite(out, x);
  }
}

}  // namespace

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
  out += fmt::format("\"{:a}\"", x);
}

}  // namespace rayproof
