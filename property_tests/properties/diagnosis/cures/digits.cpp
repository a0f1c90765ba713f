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

/// Every number changed by up to half that share of it.
Cases with_noise(const Case& one, double share, std::uint64_t seed) {
  Random random(seed);
  return with_numbers(one, [&](double x) { return x * (1 + share * (random.unit() - 0.5)); });
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
  return with_noise(one, one.precision == Precision::float32 ? 0x1p-12 : 0x1p-24, 7);
}

Cases varied(const Case& one, std::uint64_t seed) { return with_noise(one, 0x1p-2, seed); }

}  // namespace rayproof::diagnosis
