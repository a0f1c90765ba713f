#include "generators/draw.hpp"
#include "generators/family.hpp"
#include "generators/number_by_number.hpp"

namespace rayproof {

namespace quadratic_family {

/// The equation, its coefficients rounded to `T`.
template <class T>
[[nodiscard]] Quadratic<double> equation(double a, double b, double c) {
  return {static_cast<double>(static_cast<T>(a)), static_cast<double>(static_cast<T>(b)),
          static_cast<double>(static_cast<T>(c))};
}

struct Everyday {
  static constexpr const char* name = "random";
  static constexpr const char* description = "coefficients between -10 and 10";

  template <class T>
  [[nodiscard]] static Question ask(Random& random) {
    const auto coefficient = [&] { return random.uniform(-10, 10); };
    const double a = coefficient(), b = coefficient(), c = coefficient();
    return equation<T>(a, b, c);
  }
};

struct Cancelling {
  static constexpr const char* name = "cancelling";
  static constexpr const char* description = "b² >> 4ac: one root is tiny beside the other";

  template <class T>
  [[nodiscard]] static Question ask(Random& random) {
    const double digits = std::numeric_limits<T>::digits;
    const double b = draw::magnitude<double>(random, -3, 3);
    const double a = draw::magnitude<double>(random, -digits / 2, 3);
    const double ratio = std::exp2(random.uniform(4, digits));
    const double c = (random.one_in(2) ? 1 : -1) * b * b / (4 * a * ratio);
    return std::abs(c) > std::exp2(-digits) ? equation<T>(a, b, c) : equation<T>(c < 0 ? -1 : 1, b, a);
  }
};

struct NearDouble {
  static constexpr const char* name = "near_double";
  static constexpr const char* description =
      "b² ≈ 4ac: (px + q)² exactly, or a few ulps beside a double root";

  template <class T>
  [[nodiscard]] static Question ask(Random& random) {
    const auto nudge = [&](double x) -> double {
      return draw::nudged<T>(static_cast<T>(x), random.between(-3, 3));
    };
    if (random.one_in(3)) {  // Half the digits for p and q leaves the squares exact.
      const int half = (1 << (std::numeric_limits<T>::digits / 2 - 1)) - 1;
      const double p = random.between(1, half);
      const double q = random.between(-half, half);
      return random.one_in(2) ? equation<T>(p * p, 2 * p * q, q * q)
                              : equation<T>(p * p, nudge(2 * p * q), q * q);
    }
    const double a = draw::magnitude<double>(random, -3, 3);
    const double x = draw::magnitude<double>(random, -3, 3);
    const double c = nudge(a * x * x), b = nudge(-2 * a * x);
    return equation<T>(nudge(a), b, c);
  }
};

struct SmallA {
  static constexpr const char* name = "small_a";
  static constexpr const char* description = "a goes to 0, or is 0";

  template <class T>
  [[nodiscard]] static Question ask(Random& random) {
    const double a = random.one_in(4) ? 0 : draw::magnitude<double>(random, -26, -2);
    const double b = random.one_in(16) ? 0 : random.uniform(-10, 10);
    const double c = random.one_in(16) ? 0 : random.uniform(-10, 10);
    return equation<T>(a, b, c);
  }
};

struct Integers {
  static constexpr const char* name = "integers";
  static constexpr const char* description = "whole numbers, most of them factors multiplied out";

  template <class T>
  [[nodiscard]] static Question ask(Random& random) {
    const double p = random.between(-20, 20), q = random.between(-20, 20);
    const double r = random.between(-20, 20), s = random.between(-20, 20);
    switch (random.between(0, 4)) {
      case 0:
        return equation<T>(p * p, 2 * p * q, q * q);
      case 1:
      case 2:
        return equation<T>(p * r, p * s + q * r, q * s);
      default:
        return equation<T>(p, q, r);
    }
  }
};

struct Exponents {
  static constexpr const char* name = "exponents";
  static constexpr const char* description =
      "coefficients of any exponent, half the time with b² near ac in size";

  template <class T>
  [[nodiscard]] static Question ask(Random& random) {
    constexpr double lowest = draw::lowest_exponent<T>, highest = draw::highest_exponent<T>;
    const auto a = draw::magnitude<T>(random, lowest, highest);
    const auto c = draw::magnitude<T>(random, lowest, highest);
    const double between = (std::log2(std::abs(double{a})) + std::log2(std::abs(double{c}))) / 2;
    const auto b = random.one_in(2) ? draw::magnitude<T>(random, lowest, highest)
                                    : draw::magnitude<T>(random, between, std::min(between + 3, highest));
    return equation<T>(a, b, c);
  }
};

struct SpecialCoefficients : SpecialText {
  template <class T>
  [[nodiscard]] static Question ask(Random& random) {
    const T a = draw::special<T>(random), b = draw::special<T>(random), c = draw::special<T>(random);
    return equation<T>(a, b, c);
  }
};

struct AnyBits : BitPatternsText {
  template <class T>
  [[nodiscard]] static Question ask(Random& random) {
    const T a = draw::bit_pattern<T>(random), b = draw::bit_pattern<T>(random),
            c = draw::bit_pattern<T>(random);
    return equation<T>(a, b, c);
  }
};

}  // namespace quadratic_family

std::vector<Family> quadratic_families() {
  using namespace quadratic_family;
  const char* const topic = "quadratic";
  const MinimumShare all_in_reach{"in reach", 1};
  // The first family that breaks a property gives the counterexample: the most telling ones come first.
  return {
      family<Cancelling>(topic, {all_in_reach, {"two", 0.9}}),
      family<Everyday>(topic, {all_in_reach, {"two", 0.4}, {"none", 0.2}}),
      family<NearDouble>(topic, {all_in_reach, {"two", 0.2}, {"double", 0.1}, {"none", 0.2}}),
      family<SmallA>(topic, {all_in_reach, {"linear", 0.15}, {"two", 0.4}, {"constant", 0.005}}),
      family<Integers>(topic, {all_in_reach, {"two", 0.5}, {"double", 0.1}, {"none", 0.1}}),
      family<Exponents>(topic, {{"two", 0.5}, {"none", 0.05}}),
      family<SpecialCoefficients>(topic, {{"two", 0.2}, {"none", 0.1}, {"linear", 0.02}, {"double", 0.001}}),
      family<AnyBits>(topic, {{"two", 0.3}, {"none", 0.1}}),
  };
}

}  // namespace rayproof
