#pragma once
/// \file
/// The two computations of the roots of a second-degree problem that more than one shape uses.

#include <rayproof/method/narration.hpp>
#include <rayproof/roots.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// Steps of more than one kernel that solves a quadratic equation.
namespace steps {
inline constexpr Step discriminant{"Form the discriminant",
                                   "Where a is not 0, the sign of D gives the number of real roots: two for "
                                   "D > 0, one for D = 0, none for D < 0."};
inline constexpr Step quarter_discriminant{
    "Form a quarter of the discriminant",
    "With ±2b as the linear coefficient, b² − a·c is a quarter of the discriminant and has its sign."};
inline constexpr Step sum_without_cancellation{
    "Give √D the sign of b, and add",
    "√D takes the sign of b: two numbers of one sign cannot cancel, so q keeps its digits."};
inline constexpr Step roots_by_viete{
    "Take one root from q and the other from Viète",
    "One root is q / a; by Viète the product of the roots is c / a, so the other one is c / q."};
inline constexpr Step compare_with_radius{
    "Compare its distance with the radius",
    "Where the line passes within the radius, D is positive: by Pythagoras the square of half the chord. b² "
    "− 4ac of the quadratic formula is 4a·D."};
}  // namespace steps

/// The roots of a·x² + b·x + c by (-b ± √(b² - 4ac)) / 2a, the lower first where a > 0. `lower` and `upper`
/// are their names in a walkthrough.
template <class T>
[[nodiscard]] constexpr Roots<T> quadratic_formula(const T& a, const T& b, const T& c,
                                                   const char* lower = "t₀", const char* upper = "t₁") {
  step<T>(steps::discriminant);
  const T D = named("D", b * b - T(4) * a * c);

  step<T>("Apply the quadratic formula",
          "Where a is not 0 and D ≥ 0, the roots lie √D / |2a| to either side of −b / (2a); where D < 0, √D "
          "is NaN: no real root.");
  const T s = named("√D", sqrt(D));
  const T x0 = named(lower, (-b - s) / (T(2) * a));
  const T x1 = named(upper, (-b + s) / (T(2) * a));
  return {D, x0, x1};
}

/// The roots as half a chord to either side of its middle t_c, where D is the square of half the chord's
/// length and `per_a` is 1 over the square of the direction's; names as above.
template <class T>
[[nodiscard]] constexpr Roots<T> ends_of_chord(const T& t_c, const T& D, const T& per_a,
                                               const char* lower = "t₀", const char* upper = "t₁") {
  step<T>("Go half a chord to either side",
          "√D is half the chord, and h is half the chord measured in t: the line meets the surface h before "
          "and h after t_c. Where D < 0 there is no chord.");
  const T h = named("h", sqrt(D * per_a));
  return {D, named(lower, t_c - h), named(upper, t_c + h)};
}

}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
