#include "properties/worst/variation.hpp"

#include <array>
#include <bit>
#include <cmath>

#include "case/json/number_text.hpp"
#include "properties/numbers.hpp"
#include "properties/shrink/shrink.hpp"

namespace rayproof::worst {

namespace {

using Numbers = std::vector<CaseNumber>;

int digits_of(Precision precision) { return precision == Precision::float32 ? 24 : 53; }

/// 2^-k with k anywhere in the digits of the precision: as often a change of the last digits as of the first.
double any_step(Random& random, Precision precision) {
  const double exponent = random.uniform(0, digits_of(precision));
  return random.one_in(2) ? std::exp2(-exponent) : -std::exp2(-exponent);
}

double flip_bit(double x, Random& random, Precision precision) {
  const int unused = 53 - digits_of(precision);
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) ^ (1ULL << random.between(unused, 51)));
}

/// A few steps on the grid of the precision.
double step_aside(double x, Random& random, Precision precision) {
  const double ulp = std::ldexp(1.0, std::ilogb(x == 0 ? 1 : x) + 1 - digits_of(precision));
  const int reach = 1 << random.between(0, 6);
  return x + ulp * random.between(-reach, reach);
}

/// To a few leading bits.
double shorten(double x, Random& random) {
  if (x == 0) return x;
  const double unit = std::ldexp(1.0, std::ilogb(x) - random.between(0, 12));
  return std::round(x / unit) * unit;
}

double scaled_by_power(double x, Random& random) {
  const int reach = 1 << random.between(0, 5);
  return std::ldexp(x, random.between(-reach, reach));
}

double changed_number(double x, const Numbers& all, const CaseNumber& own, Random& random,
                      Precision precision) {
  switch (random.between(0, 11)) {
    case 0:
      return flip_bit(x, random, precision);
    case 1:
      return step_aside(x, random, precision);
    case 2:
      return scaled_by_power(x, random);
    case 3:
      return -x;
    case 4:
      return shorten(x, random);
    case 5:
      return *all[static_cast<std::size_t>(random.between(0, static_cast<int>(all.size()) - 1))].value;
    case 6:
      return random.one_in(4) ? own.plain : x * random.uniform(0.5, 2);
    default:
      return x * (1 + any_step(random, precision));
  }
}

/// A run of numbers of one name: a vector, or a list of them.
struct Group {
  std::size_t begin, size;
};

/// The groups of at most three numbers, so that a polygon's vertices move one by one.
std::vector<Group> groups_of(const Numbers& all) {
  std::vector<Group> groups;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool goes_on = !groups.empty() && groups.back().size < 3 && all[i].field == all[i - 1].field;
    if (goes_on)
      ++groups.back().size;
    else
      groups.push_back({i, 1});
  }
  return groups;
}

/// Scales a vector, or moves it by a part of another one: along the ray, say.
void change_vector(const Numbers& all, Random& random, Precision precision) {
  const std::vector<Group> groups = groups_of(all);
  const auto any = [&] {
    return groups[static_cast<std::size_t>(random.between(0, static_cast<int>(groups.size()) - 1))];
  };
  const Group to = any(), from = any();
  const bool is_moved = to.size == from.size && random.one_in(2);
  const double factor =
      random.one_in(2) ? std::ldexp(1.0, random.between(-8, 8)) : 1 + any_step(random, precision);
  const double share = any_step(random, precision) * std::ldexp(1.0, random.between(0, 8));
  for (std::size_t i = 0; i < to.size; ++i) {
    double& x = *all[to.begin + i].value;
    x = is_moved ? x + share * *all[from.begin + i].value : x * factor;
  }
}

void change(const Numbers& all, const Numbers& of_mate, Random& random, Precision precision) {
  if (random.one_in(4)) return change_vector(all, random, precision);
  const auto k = static_cast<std::size_t>(random.between(0, static_cast<int>(all.size()) - 1));
  double& x = *all[k].value;
  if (!std::isfinite(x)) return;  // an end of the interval that there is not
  x = random.one_in(16) && of_mate.size() == all.size() ? *of_mate[k].value
                                                        : changed_number(x, all, all[k], random, precision);
}

}  // namespace

/// The case once its numbers were changed, where it is one.
static std::optional<Case> rounded_case(Case&& one, const Numbers& numbers) {
  for (const CaseNumber& number : numbers) *number.value = round_to(one.precision, *number.value);
  if (!is_valid(one)) return std::nullopt;
  return std::move(one);
}

std::optional<Case> moved_on(const Case& from, const Case& to, double share) {
  Case start = from, result = to;
  const Numbers all = numbers_of(result), before = numbers_of(start);
  if (all.size() != before.size()) return std::nullopt;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (double& x = *all[k].value; std::isfinite(x)) x += share * (x - *before[k].value);
  return rounded_case(std::move(result), all);
}

std::optional<Case> varied(const Case& one, const Case& mate, Random& random) {
  Case result = one, other = mate;
  const Numbers all = numbers_of(result), of_mate = numbers_of(other);
  int changes = 1;
  while (changes < 6 && random.one_in(2)) ++changes;
  for (int i = 0; i < changes; ++i) change(all, of_mate, random, one.precision);
  return rounded_case(std::move(result), all);
}

}  // namespace rayproof::worst
