#include "dossier/by_hand/fractions.hpp"

#include <fmt/format.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <stdexcept>

namespace rayproof::dossier {
namespace {

using boost::multiprecision::cpp_bin_float_100;
using boost::multiprecision::cpp_int;

const std::vector<double>& numbers_in(const NamedNumbers& inputs, const std::string& name) {
  const auto found = inputs.find(name);
  if (found == inputs.end()) throw std::runtime_error("the numbers lack " + name);
  return found->second;
}

std::string digits(double number) { return fmt::format("{}", number); }

}  // namespace

std::string shown(const HandNumber& number) {
  const auto near = number.value.convert_to<double>();
  if (!number.is_rational) return "≈ " + digits(near);
  const bool is_double = std::isfinite(near) && Fraction(near) == number.value;
  if (is_double && digits(near).size() <= 12) return digits(near);
  const cpp_int above = boost::multiprecision::numerator(number.value),
                below = boost::multiprecision::denominator(number.value);
  const std::string fraction = above.str() + "/" + below.str();
  if (below != 1 && fraction.size() <= 12) return fraction;
  return (is_double ? "" : "≈ ") + digits(near);
}

std::string shown(const Fraction& number) { return shown(HandNumber{number}); }

std::string shown(const FractionVector& v) {
  return fmt::format("({}, {}, {})", shown(v.x), shown(v.y), shown(v.z));
}

HandNumber root_of(const Fraction& square) {
  const cpp_int above = boost::multiprecision::numerator(square),
                below = boost::multiprecision::denominator(square);
  const cpp_int root_above = boost::multiprecision::sqrt(above),
                root_below = boost::multiprecision::sqrt(below);
  if (root_above * root_above == above && root_below * root_below == below)
    return {Fraction(root_above, root_below), true};
  const cpp_bin_float_100 near = boost::multiprecision::sqrt(square.convert_to<cpp_bin_float_100>());
  return {Fraction(near), false};
}

Fraction fraction_in(const NamedNumbers& inputs, const std::string& name) {
  const std::vector<double>& numbers = numbers_in(inputs, name);
  if (numbers.size() != 1 || !std::isfinite(numbers[0])) throw std::runtime_error(name + " is no number");
  return Fraction(numbers[0]);
}

std::vector<FractionVector> vectors_in(const NamedNumbers& inputs, const std::string& name) {
  const std::vector<double>& numbers = numbers_in(inputs, name);
  std::vector<FractionVector> all;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
    all.push_back({Fraction(numbers[i]), Fraction(numbers[i + 1]), Fraction(numbers[i + 2])});
  return all;
}

FractionVector vector_in(const NamedNumbers& inputs, const std::string& name) {
  const std::vector<FractionVector> all = vectors_in(inputs, name);
  if (all.size() != 1) throw std::runtime_error(name + " is no vector");
  return all.front();
}

}  // namespace rayproof::dossier
