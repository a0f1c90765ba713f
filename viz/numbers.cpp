#include "viz/numbers.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace rayproof::viz {
namespace {

/// "1.5e+07" as "1.5e7".
std::string without_padding(std::string text) {
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return text;
  std::size_t digits = e + 1;
  const bool is_negative = text[digits] == '-';
  while (digits < text.size() && (text[digits] == '+' || text[digits] == '-' || text[digits] == '0'))
    ++digits;
  return text.substr(0, e) + (is_negative ? "e-" : "e") + text.substr(digits);
}

std::string special(double value) {
  if (std::isnan(value)) return "NaN";
  return value > 0 ? "∞" : "-∞";
}

/// Position of a number among all numbers of its format, 0 and -0 being one.
template <class Bits, class T>
double ordinal(T value) {
  const Bits bits = std::bit_cast<Bits>(std::abs(value));
  return std::signbit(value) ? -static_cast<double>(bits) : static_cast<double>(bits);
}

/// "1 ulp", "639 ulps", "3.9e7 ulps".
std::string in_ulps(double ulps) {
  if (ulps == 1) return "1 ulp";
  return fmt::format("{} ulps", ulps < 1e6 ? rough(ulps, 6) : rough(ulps, 2));
}

}  // namespace

std::string shown(double value, Precision precision) {
  if (!std::isfinite(value)) return special(value);
  return without_padding(precision == Precision::float32 ? fmt::format("{}", static_cast<float>(value))
                                                         : fmt::format("{}", value));
}

std::string rough(double value, int digits) {
  if (!std::isfinite(value)) return special(value);
  return without_padding(fmt::format("{:.{}g}", value, digits));
}

std::string rough(const Shadow& value, int digits) {
  if (isnan(value) || isinf(value)) return special(static_cast<double>(value));
  const auto nearest = static_cast<double>(value);
  if (value == 0 || std::isnormal(nearest)) return rough(nearest, digits);
  // Beyond double's range: a decimal exponent, and what is left in [1, 10).
  int binary = 0;
  (void)frexp(value, &binary);
  auto exponent = static_cast<int>(std::floor((binary - 1) * std::log10(2.0)));
  if (abs(value) >= pow(Shadow(10), exponent + 1)) ++exponent;
  return fmt::format("{}e{}", rough(static_cast<double>(value / pow(Shadow(10), exponent)), digits),
                     exponent);
}

std::string scale_in_words(const Shadow& times) {
  return times < 1 ? fmt::format("Reduced to 1/{}", rough(1 / times, 2))
                   : fmt::format("Magnified ×{}", rough(times, 2));
}

std::string subscript(std::size_t index) {
  static constexpr const char* digits[] = {"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};
  return index < 10 ? digits[index] : std::to_string(index);
}

double count_ulps(double a, double b, Precision precision) {
  if (a == b) return 0;
  if (!std::isfinite(a) || !std::isfinite(b)) return std::numeric_limits<double>::infinity();
  if (precision == Precision::float64) return std::abs(ordinal<std::uint64_t>(a) - ordinal<std::uint64_t>(b));
  return std::abs(ordinal<std::uint32_t>(static_cast<float>(a)) -
                  ordinal<std::uint32_t>(static_cast<float>(b)));
}

std::string off_by(double ulps) {
  return std::isinf(ulps) ? "infinitely far off" : fmt::format("off by {}", in_ulps(ulps));
}

std::string apart_in_words(double a, double b, Precision precision) {
  const double ulps = count_ulps(a, b, precision);
  return ulps == 0 ? "equal" : std::isinf(ulps) ? "infinitely far" : in_ulps(ulps);
}

}  // namespace rayproof::viz
