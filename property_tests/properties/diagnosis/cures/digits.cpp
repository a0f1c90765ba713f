#include <cmath>

#include "generators/random.hpp"
#include "properties/diagnosis/cures/cures.hpp"

namespace rayproof::diagnosis {
namespace {

/// The case with every number x made `change(x)`.
template <class DoChange>
Cases with_numbers(const Case& one, DoChange&& change) {
  Case changed = one;
  for (const CaseNumber& number : numbers_of(changed))
    if (*number.value != 0 && std::isfinite(*number.value)) *number.value = change(*number.value);
  return if_valid(std::move(changed));
}

/// x rounded to a number of bits.
double to_bits(double x, int bits) {
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  return std::ldexp(std::round(std::ldexp(mantissa, bits)), exponent - bits);
}

}  // namespace

Cases unchanged(const Case& one) { return {one}; }

Cases in_double(const Case& one) {
  if (one.precision == Precision::float64) return {};
  Case changed = one;
  changed.precision = Precision::float64;
  return {changed};
}

Cases few_digits(const Case& one) {
  Cases all;
  for (const int bits : {12, 8, 5})
    for (const Case& changed : with_numbers(one, [bits](double x) { return to_bits(x, bits); }))
      all.push_back(changed);
  return all;
}

Cases jiggled(const Case& one) {
  const double step = one.precision == Precision::float32 ? 0x1p-12 : 0x1p-24;
  Random random(7);
  return with_numbers(one, [&](double x) { return x * (1 + step * (random.unit() - 0.5)); });
}

}  // namespace rayproof::diagnosis
