#pragma once
/// \file
/// Problems for every method of every topic, from tame to the ends of the exponent range.

#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <rayproof/topics.hpp>
#include <vector>

#include "subjects/reading.hpp"
#include "unit/shape_types.hpp"
#include "viz/trace/record.hpp"

namespace rayproof::viz {

/// Numbers of either sign whose exponents are uniform within ±`largest`, some of them whole, some of them 0.
class CaseSource {
 public:
  explicit CaseSource(std::uint64_t seed) : bits_(seed) {}

  std::uint64_t bits() { return bits_(); }

  double number(int largest) {
    const auto kind = bits_() % 16;
    if (kind == 0) return 0;
    const double sign = bits_() % 2 == 0 ? 1 : -1;
    if (kind < 4) return sign * static_cast<double>(bits_() % 8);
    const double significand = 1 + static_cast<double>(bits_() >> 11) * 0x1p-53;
    const int exponent = static_cast<int>(bits_() % static_cast<unsigned>(2 * largest + 1)) - largest;
    return sign * std::ldexp(significand, exponent);
  }
  /// A number one last bit or so away from another.
  double beside(double x) { return x * (1 + static_cast<double>(bits_() % 5) * 0x1p-23 - 0x1p-22); }

  template <class T>
  T rounded(int largest) {
    return static_cast<T>(number(largest));
  }

 private:
  std::mt19937_64 bits_;
};

template <class T>
[[nodiscard]] quadratic::Topic::Problem<T> random_problem(quadratic::Topic /*topic*/, CaseSource& source,
                                                          int largest) {
  const T b = source.rounded<T>(largest);
  const T a = source.rounded<T>(largest);
  const bool is_near_double = source.number(1) > 0 && a != 0;
  const T c = is_near_double ? static_cast<T>(source.beside(static_cast<double>(b * b / (4 * a))))
                             : source.rounded<T>(largest);
  return {a, b, c};
}

/// Rays of every topic of shapes.
template <class T, class Topic>
[[nodiscard]] typename Topic::template Problem<T> random_problem(Topic /*topic*/, CaseSource& source,
                                                                 int largest) {
  // Erased, since all that reads shapes is compiled for each type of number().
  const std::function<double()> number = [&] { return static_cast<double>(source.rounded<T>(largest)); };
  Random forms(source.bits());
  return Reading<Topic>::template problem<T>({.question = question_of_topic(Topic::name, forms, number)});
}

/// Many problems of the topic, the same at each call. Out of line: compiled once, not once for each method.
template <class T, class Topic>
[[nodiscard, gnu::noinline]] std::vector<typename Topic::template Problem<T>> many_problems() {
  CaseSource source(20);
  std::vector<typename Topic::template Problem<T>> problems;
  for (const int largest : {0, 4, 20, std::numeric_limits<T>::max_exponent - 1})
    for (int i = 0; i < 400; ++i) problems.push_back(random_problem<T>(Topic{}, source, largest));
  return problems;
}

/// Calls `check.operator()<Topic, Method>(problem)` with many problems.
template <class T, class Topic, class Method, class Check>
void put_problems(Check&& check) {
  for (const auto& problem : many_problems<T, Topic>()) check.template operator()<Topic, Method>(problem);
}

/// The same for every method that takes any arithmetic.
template <class T, class Check>
void for_every_recordable_method(Check&& check) {
  Topics::for_each([&]<class Topic>(std::type_identity<Topic>) {
    Topic::Methods::for_each([&]<class Method>(std::type_identity<Method>) {
      if constexpr (Recordable<Method, Recorded<T, Shadow>>) {
        put_problems<T, Topic, Method>(check);
      }
    });
  });
}

}  // namespace rayproof::viz
