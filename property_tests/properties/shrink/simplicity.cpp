#include "properties/shrink/shrink.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include "properties/numbers.hpp"

namespace rayproof {

namespace {

/// x = ±digits · 10^exponent with one digit before the point.
struct Decimal {
  unsigned digits = 0;
  unsigned size_of_exponent = 0;
  unsigned leading = 0;
};

Decimal decimal(double x, Precision precision) {
  std::array<char, 32> text{};
  char* const begin = text.data();
  char* const end = begin + text.size();
  constexpr auto format = std::chars_format::scientific;
  const double magnitude = std::abs(x);
  const auto written = precision == Precision::float32
                           ? std::to_chars(begin, end, static_cast<float>(magnitude), format)
                           : std::to_chars(begin, end, magnitude, format);
  const char* const e = std::find(begin, written.ptr, 'e');
  const auto mantissa = static_cast<unsigned>(e - begin);
  const int exponent = std::atoi(e + 1);  // the array's zeros end the text
  return {mantissa - (mantissa > 1 ? 1 : 0), static_cast<unsigned>(std::abs(exponent)),
          static_cast<unsigned>(*begin - '0')};
}

constexpr unsigned too_many_digits = 1000;
constexpr unsigned a_transform = 60;
constexpr unsigned a_digit = 8;
constexpr unsigned a_number = 20;  // so that a polygon gets simpler by losing a vertex

unsigned cost(const CaseNumber& number, Precision precision) {
  const double x = *number.value;
  if (x == number.plain) return std::signbit(x) && x == 0 ? 1 : 0;
  if (x == 0 || std::isinf(x)) return 2;
  const Decimal d = decimal(x, precision);
  const unsigned beyond = d.digits > 3 ? d.digits - 3 : 0;
  const bool is_whole = std::trunc(x) == x;
  return beyond * too_many_digits + d.digits * a_digit + 2 * d.size_of_exponent + (d.leading > 1 ? 1 : 0) +
         (std::signbit(x) ? 1 : 0) + (is_whole ? 0 : 2);
}

}  // namespace

unsigned significant_digits(double x, Precision precision) {
  return x == 0 || !std::isfinite(x) ? 0 : decimal(x, precision).digits;
}

unsigned complexity(const Case& one) {
  Case copy = one;
  unsigned sum = 0;
  std::vector<double> different;
  for (const CaseNumber& number : numbers_of(copy)) {
    sum += a_number + cost(number, one.precision);
    const double size = std::abs(*number.value);
    if (size != 0 && std::find(different.begin(), different.end(), size) == different.end())
      different.push_back(size);
  }
  const auto* asked = std::get_if<RayQuestion>(&one.question);
  if (asked != nullptr && asked->transform) sum += a_transform;
  return sum + static_cast<unsigned>(different.size());
}

}  // namespace rayproof
