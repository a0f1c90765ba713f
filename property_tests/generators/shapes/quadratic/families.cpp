#include "generators/number_by_number.hpp"

namespace rayproof {

namespace quadratic_family {

[[nodiscard]] Question equation(Precision precision, double a, double b, double c) {
  return rounded(precision, Quadratic<double>{a, b, c});
}

[[nodiscard]] Question everyday(Random& random, Precision precision) {
  const double a = random.uniform(-10, 10), b = random.uniform(-10, 10), c = random.uniform(-10, 10);
  return equation(precision, a, b, c);
}

[[nodiscard]] Question cancelling(Random& random, Precision precision) {
  const double digits = draw::digits_of(precision);
  const double b = draw::magnitude<double>(random, -3, 3);
  const double a = draw::magnitude<double>(random, -digits / 2, 3);
  const double ratio = std::exp2(random.uniform(4, digits));
  const double c = (random.one_in(2) ? 1 : -1) * b * b / (4 * a * ratio);
  return std::abs(c) > std::exp2(-digits) ? equation(precision, a, b, c)
                                          : equation(precision, c < 0 ? -1 : 1, b, a);
}

[[nodiscard]] Question near_double(Random& random, Precision precision) {
  const auto nudge = [&](double x) { return draw::nudged(precision, x, random.between(-3, 3)); };
  if (random.one_in(3)) {  // Half the digits for p and q leaves the squares exact.
    const int half = (1 << (draw::digits_of(precision) / 2 - 1)) - 1;
    const double p = random.between(1, half);
    const double q = random.between(-half, half);
    // Beside 0 lie numbers that no contract reaches.
    return equation(precision, p * p, q == 0 || random.one_in(2) ? 2 * p * q : nudge(2 * p * q), q * q);
  }
  const double a = draw::magnitude<double>(random, -3, 3);
  const double x = draw::magnitude<double>(random, -3, 3);
  const double c = nudge(a * x * x), b = nudge(-2 * a * x);
  return equation(precision, nudge(a), b, c);
}

[[nodiscard]] Question small_a(Random& random, Precision precision) {
  const double a = random.one_in(4) ? 0 : draw::magnitude<double>(random, -26, -2);
  const double b = random.one_in(16) ? 0 : random.uniform(-10, 10);
  const double c = random.one_in(16) ? 0 : random.uniform(-10, 10);
  return equation(precision, a, b, c);
}

/// ±1, ±2, ±4 or seldom 0: what the roots of short factors are divided by.
[[nodiscard]] double short_divisor(Random& random) {
  const double sign = random.one_in(2) ? -1 : 1;
  return random.one_in(8) ? 0 : sign * std::exp2(random.between(0, 2));
}

[[nodiscard]] Question whole(Random& random, Precision precision) {
  const bool is_short = random.one_in(2);
  const auto divisor = [&] { return is_short ? short_divisor(random) : random.between(-20, 20); };
  const double p = divisor(), q = random.between(-20, 20), r = divisor(), s = random.between(-20, 20);
  const int kind = random.between(0, 4);
  if (kind == 0) return equation(precision, p * p, 2 * p * q, q * q);
  return kind <= 2 ? equation(precision, p * r, p * s + q * r, q * s) : equation(precision, p, q, r);
}

[[nodiscard]] Question exponents(Random& random, Precision precision) {
  const auto any = [&] {
    const double x = round_to(precision, std::exp2(draw::any_exponent(random, precision, 0)));
    return random.one_in(2) ? x : -x;
  };
  const double a = any(), c = any();
  const double between = (std::log2(std::abs(a)) + std::log2(std::abs(c))) / 2;
  const double highest =
      in_precision(precision, []<class T>(T) -> double { return draw::highest_exponent<T>; });
  const double b =
      random.one_in(2) ? any() : draw::magnitude<double>(random, between, std::min(between + 3, highest));
  return equation(precision, a, b, c);
}

[[nodiscard]] Family asked(const char* name, const char* description, Question (*ask)(Random&, Precision),
                           std::vector<MinimumShare> shares) {
  return {name, description, ask, std::move(shares)};
}

}  // namespace quadratic_family

std::vector<Family> quadratic_families() {
  using namespace quadratic_family;
  const MinimumShare all_in_reach{"in reach", 1};
  return {
      asked("cancelling", "b² >> 4ac: one root is tiny beside the other", cancelling,
            {all_in_reach, {"two", 0.9}}),
      asked("random", "coefficients between -10 and 10", everyday,
            {all_in_reach, {"two", 0.4}, {"none", 0.2}}),
      asked("near_double", "b² ≈ 4ac: (px + q)² exactly, or a few ulps beside a double root", near_double,
            {all_in_reach, {"two", 0.2}, {"double", 0.1}, {"none", 0.2}}),
      asked("small_a", "a goes to 0, or is 0", small_a,
            {all_in_reach, {"linear", 0.15}, {"two", 0.4}, {"constant", 0.005}}),
      asked("whole", "so short that little is rounded: most of them factors multiplied out", whole,
            {all_in_reach,
             {"two", 0.5},
             {"double", 0.1},
             {"none", 0.07},
             {"linear", 0.06},
             {"constant", 0.01}}),
      asked("exponents", "coefficients of any exponent, half the time with b² near ac in size", exponents,
            {{"two", 0.5}, {"none", 0.05}}),
      special<Quadratic<double>>({{"two", 0.2}, {"none", 0.1}, {"linear", 0.02}, {"double", 0.001}}),
      bit_patterns<Quadratic<double>>({{"two", 0.3}, {"none", 0.1}}),
  };
}

}  // namespace rayproof
