#include "viz/trace/numbers.hpp"

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

/// How many numbers of the format lie between 0 and a finite one: its bits without the sign.
template <class Bits, class T>
std::uint64_t count_from_zero(T value) {
  return std::bit_cast<Bits>(std::abs(value));
}

/// In integers: the bits of a double have more digits than a double. The sum of two counts fits, since each
/// of them is below 2^63.
template <class Bits, class T>
double count_between(T a, T b) {
  const std::uint64_t x = count_from_zero<Bits>(a);
  const std::uint64_t y = count_from_zero<Bits>(b);
  if (std::signbit(a) != std::signbit(b)) return static_cast<double>(x + y);
  return static_cast<double>(x > y ? x - y : y - x);
}

}  // namespace

std::string shown(double value, Precision precision) {
  if (!std::isfinite(value)) return special(value);
  return without_padding(precision == Precision::float32 ? fmt::format("{}", static_cast<float>(value))
                                                         : fmt::format("{}", value));
}

std::string shown(const glm::dvec3& v, Precision precision) {
  return fmt::format("({}, {}, {})", shown(v.x, precision), shown(v.y, precision), shown(v.z, precision));
}

std::string rough(double value, int digits) {
  if (!std::isfinite(value)) return special(value);
  return without_padding(fmt::format("{:.{}g}", value, digits));
}

std::string rough(const Shadow& value, int digits) {
  if (isnan(value) || isinf(value) || value == 0) return rough(static_cast<double>(value), digits);
  return without_padding(in_digits(value, digits, false));
}

std::string exact_beside(const Shadow& exact, double value, int bits) {
  if (!isfinite(exact) || exact == 0) return rough(exact);
  if (exact == Shadow(value)) return shown(value, Precision::float64);
  constexpr int most = 40;  // what differs later differs by the roundings of the 320 bits themselves
  int digits = bits == std::numeric_limits<float>::digits ? 12 : 17;
  if (std::isfinite(value)) {
    while (digits < most && in_digits(exact, digits, true) == in_digits(Shadow(value), digits, true))
      ++digits;
  }
  return without_padding(in_digits(exact, digits, true));
}

std::string scale_in_words(const Shadow& times) {
  if (rough(times, 2) == "1" || rough(1 / times, 2) == "1") return "In true size";
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
  return precision == Precision::float64
             ? count_between<std::uint64_t>(a, b)
             : count_between<std::uint32_t>(static_cast<float>(a), static_cast<float>(b));
}

std::string in_ulps(double ulps) {
  if (ulps == 1) return "1 ulp";
  return fmt::format("{} ulps", ulps < 1e6 ? rough(ulps, 6) : rough(ulps, 2));
}

std::string accuracy_in_words(double ulps) {
  if (ulps == 0) return "the exact one, correctly rounded";
  return std::isinf(ulps) ? "infinitely far off" : fmt::format("off by {}", in_ulps(ulps));
}

std::string apart_in_words(double a, double b, Precision precision) {
  const double ulps = count_ulps(a, b, precision);
  if (ulps == 0) return "equal";
  if (std::isinf(ulps)) return "infinitely far";
  // Of what is wrong in the first digits, or near 0, a number of ulps says nothing.
  constexpr double many = 100, grossly = 0.01;
  return ulps > many && std::abs(b - a) > grossly * std::abs(a) ? rough(std::abs(b - a), 2) : in_ulps(ulps);
}

}  // namespace rayproof::viz
