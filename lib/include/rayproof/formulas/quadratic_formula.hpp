#pragma once
/// \file
/// The two ways from a second-degree problem to its roots that more than one shape takes.

#include <rayproof/method/narration.hpp>
#include <rayproof/roots.hpp>

namespace rayproof {

/// The roots of a·x² + b·x + c by (-b ± √(b² - 4ac)) / 2a, the lower first where a > 0. `lower` and `upper`
/// are their names in a walkthrough.
template <class T>
[[nodiscard]] constexpr Roots<T> quadratic_formula(const T& a, const T& b, const T& c,
                                                   const char* lower = "t₀", const char* upper = "t₁") {
  step<T>("Form the discriminant");
  const T D = named("D", b * b - T(4) * a * c);

  step<T>("Apply the quadratic formula");
  const T s = named("√D", sqrt(D));
  const T x0 = named(lower, (-b - s) / (T(2) * a));
  const T x1 = named(upper, (-b + s) / (T(2) * a));
  return {D, x0, x1};
}

/// The roots as half a chord to either side of its middle t_c, where D is the square of half the chord's
/// length and `per_a` is 1 over the square of the direction's.
template <class T>
[[nodiscard]] constexpr Roots<T> ends_of_chord(const T& t_c, const T& D, const T& per_a) {
  step<T>("Go half a chord to either side");
  const T h = named("h", sqrt(D * per_a));
  return {D, named("t₀", t_c - h), named("t₁", t_c + h)};
}

}  // namespace rayproof
