#include "viz/numbers.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>

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
  const bool is_in_range = value == 0 || (std::isnormal(nearest) && digits <= 15);
  return is_in_range ? rough(nearest, digits) : without_padding(value.str(digits));
}

std::string subscript(std::size_t index) {
  static constexpr const char* digits[] = {"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};
  return index < 10 ? digits[index] : std::to_string(index);
}

std::string ulps_apart(double a, double b, Precision precision) {
  if (a == b) return "equal";
  if (std::isnan(a) || std::isnan(b)) return "no number";
  const double apart = precision == Precision::float32
                           ? std::abs(ordinal<std::uint32_t>(static_cast<float>(a)) -
                                      ordinal<std::uint32_t>(static_cast<float>(b)))
                           : std::abs(ordinal<std::uint64_t>(a) - ordinal<std::uint64_t>(b));
  if (apart <= 1) return "1 ulp";
  return (apart < 1e6 ? rough(apart, 6) : rough(apart, 2)) + " ulps";
}

}  // namespace rayproof::viz
