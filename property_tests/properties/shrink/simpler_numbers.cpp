#include "properties/shrink/moves.hpp"

#include <cmath>

#include "case/json/number_text.hpp"

namespace rayproof {

namespace {

/// 10^k without the rounding of std::pow for negative k: 3 · 10^-2 must come out as 0.03.
double times_power_of_ten(double x, int k) { return k < 0 ? x / std::pow(10.0, -k) : x * std::pow(10.0, k); }

int decimal_exponent(double x) { return static_cast<int>(std::floor(std::log10(std::abs(x)))); }

void append_short_mantissas(std::vector<double>& all, double x) {
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  for (int bits = 1; bits <= 6; ++bits) {
    const double whole = std::ldexp(mantissa, bits);
    for (const double cut : {std::trunc(whole), whole < 0 ? std::floor(whole) : std::ceil(whole)})
      all.push_back(std::ldexp(cut, exponent - bits));
  }
}

}  // namespace

double to_digits(double x, int digits, int steps, Precision precision) {
  if (x == 0 || !std::isfinite(x)) return x;
  const int last = decimal_exponent(x) - digits + 1;
  return round_to(precision, times_power_of_ten(std::round(times_power_of_ten(x, -last)) + steps, last));
}

std::vector<double> simpler_numbers(double x, Precision precision) {
  std::vector<double> all{0, 1, -1};
  if (!std::isfinite(x)) return all;
  if (x != 0) {
    const int e = decimal_exponent(x);
    for (const int k : {e, e + 1, e / 2, e - (e > 0 ? 1 : -1)}) {
      all.push_back(times_power_of_ten(1, k));
      all.push_back(times_power_of_ten(-1, k));
    }
    for (int digits = 1; digits <= 3; ++digits)
      for (const int steps : {0, -1, 1}) all.push_back(to_digits(x, digits, steps, precision));
    all.insert(all.end(), {std::trunc(x), std::round(x), -x, x / 2, x * 2, x / 10, x * 10});
    append_short_mantissas(all, x);
    for (int digits = 4; digits <= 12; ++digits) all.push_back(to_digits(x, digits, 0, precision));
  }
  for (double& candidate : all) candidate = round_to(precision, candidate);
  return all;
}

}  // namespace rayproof
