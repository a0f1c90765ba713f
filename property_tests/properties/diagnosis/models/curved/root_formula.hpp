#pragma once
/// \file
/// Models of faults in the formula for two roots: of a quadratic equation, and of the one that a ray makes
/// with a sphere or with the side of a cylinder.

#include <array>
#include <cmath>

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// a x² + 2 h x + c = 0.
struct ReducedEquation {
  double a = 0, h = 0, c = 0;
  [[nodiscard]] double discriminant() const { return h * h - a * c; }
};

/// The equation of the case, a not 0; nothing where it has none.
[[nodiscard]] std::optional<ReducedEquation> reduced_equation(const Case& one);

/// What a formula finds: two roots, not in order, or none.
using FoundRoots = std::optional<std::array<double, 2>>;
using RootFormula = FoundRoots (*)(const ReducedEquation& equation);

/// The answers of a subject that finds these roots.
[[nodiscard]] Answers with_roots(const Case& one, const FoundRoots& roots);

/// The answers of a subject that computes the roots by one of these formulas.
template <RootFormula... formulas>
[[nodiscard]] Answers by_formula(const Case& one, const Answer& exact) {
  const std::optional<ReducedEquation> equation = reduced_equation(one);
  const auto* ray = std::get_if<RayAnswer>(&exact);
  if (!equation || (ray != nullptr && !std::isfinite(equation->a))) return {};
  Answers all;
  for (const RootFormula formula : {formulas...})
    for (Answer& answer : with_roots(one, formula(*equation))) all.push_back(std::move(answer));
  return all;
}

/// (minus_b ± √D) / divisor; none where D < 0.
[[nodiscard]] inline FoundRoots roots_by(double minus_b, double D, double divisor) {
  if (!(D >= 0)) return std::nullopt;
  const double s = std::sqrt(D);
  return std::array{(minus_b - s) / divisor, (minus_b + s) / divisor};
}

/// @{ The discriminant is wrong: 4ac where b is halved; ac, or 2ac, where it is not; with another sign.
[[nodiscard]] inline FoundRoots four_with_half(const ReducedEquation& e) {
  return roots_by(-e.h, e.h * e.h - 4 * e.a * e.c, e.a);
}
[[nodiscard]] inline FoundRoots no_four(const ReducedEquation& e) {
  return roots_by(-2 * e.h, 4 * e.h * e.h - e.a * e.c, 2 * e.a);
}
[[nodiscard]] inline FoundRoots two_for_four(const ReducedEquation& e) {
  return roots_by(-2 * e.h, 4 * e.h * e.h - 2 * e.a * e.c, 2 * e.a);
}
[[nodiscard]] inline FoundRoots plus_for_minus(const ReducedEquation& e) {
  return roots_by(-e.h, e.h * e.h + e.a * e.c, e.a);
}
/// @}
/// @{ The same discriminants in the formula that does not cancel: x = -(h ± √D) / a, the sign that of h, and
/// c / (a x).
[[nodiscard]] inline FoundRoots without_cancelling(const ReducedEquation& e, double D) {
  if (!(D >= 0)) return std::nullopt;
  const double q = -(e.h + std::copysign(std::sqrt(D), e.h));
  return std::array{q / e.a, e.c / q};
}
[[nodiscard]] inline FoundRoots stable_four_with_half(const ReducedEquation& e) {
  return without_cancelling(e, e.h * e.h - 4 * e.a * e.c);
}
[[nodiscard]] inline FoundRoots stable_no_four(const ReducedEquation& e) {
  return without_cancelling(e, e.h * e.h - e.a * e.c / 4);
}
[[nodiscard]] inline FoundRoots stable_two_for_four(const ReducedEquation& e) {
  return without_cancelling(e, e.h * e.h - e.a * e.c / 2);
}
[[nodiscard]] inline FoundRoots stable_plus_for_minus(const ReducedEquation& e) {
  return without_cancelling(e, e.h * e.h + e.a * e.c);
}
/// @}
/// @{ Of one root alone -b has the wrong sign.
[[nodiscard]] inline FoundRoots second_with_b(const ReducedEquation& e) {
  const FoundRoots right = roots_by(-e.h, e.discriminant(), e.a);
  return right ? FoundRoots(std::array{(*right)[0], -(*right)[0]}) : std::nullopt;
}
[[nodiscard]] inline FoundRoots first_with_b(const ReducedEquation& e) {
  const FoundRoots right = roots_by(-e.h, e.discriminant(), e.a);
  return right ? FoundRoots(std::array{-(*right)[1], (*right)[1]}) : std::nullopt;
}
/// @}
/// @{ b where its half belongs, and its half where b belongs.
[[nodiscard]] inline FoundRoots whole_for_half(const ReducedEquation& e) {
  return roots_by(-2 * e.h, 4 * e.h * e.h - e.a * e.c, e.a);
}
[[nodiscard]] inline FoundRoots half_for_whole(const ReducedEquation& e) {
  return roots_by(-e.h, e.h * e.h - 4 * e.a * e.c, 2 * e.a);
}
/// @}
/// @{ D stands where √D belongs: of the reduced form, of the whole one, and of a chord's half, squared.
[[nodiscard]] inline FoundRoots unrooted_by(double minus_b, double D, double divisor) {
  if (D < 0) return std::nullopt;
  return std::array{(minus_b - D) / divisor, (minus_b + D) / divisor};
}
[[nodiscard]] inline FoundRoots no_root_of_half(const ReducedEquation& e) {
  return unrooted_by(-e.h, e.discriminant(), e.a);
}
[[nodiscard]] inline FoundRoots no_root_of_whole(const ReducedEquation& e) {
  return unrooted_by(-2 * e.h, 4 * e.discriminant(), 2 * e.a);
}
[[nodiscard]] inline FoundRoots no_root_of_chord(const ReducedEquation& e) {
  return unrooted_by(-e.h, e.discriminant() / std::sqrt(e.a), e.a);
}
/// @}
/// @{ The same in the formula that does not cancel.
[[nodiscard]] inline FoundRoots stable_no_root(const ReducedEquation& e, double D) {
  if (D < 0) return std::nullopt;
  const double q = -(e.h + std::copysign(D, e.h));
  return std::array{q / e.a, e.c / q};
}
[[nodiscard]] inline FoundRoots stable_no_root_of_half(const ReducedEquation& e) {
  return stable_no_root(e, e.discriminant());
}
[[nodiscard]] inline FoundRoots stable_no_root_of_whole(const ReducedEquation& e) {
  return stable_no_root(e, 2 * e.discriminant());
}
/// @}
/// @{ Of -b ± √D the divisor is that of one alone, or of neither; of the whole form and of the reduced one.
[[nodiscard]] inline FoundRoots root_divided(const ReducedEquation& e) {
  return roots_by(-2 * e.h, e.discriminant() / (e.a * e.a), 1);
}
[[nodiscard]] inline FoundRoots root_divided_of_half(const ReducedEquation& e) {
  return roots_by(-e.h, e.discriminant() / (e.a * e.a), 1);
}
[[nodiscard]] inline FoundRoots b_divided(const ReducedEquation& e) {
  return roots_by(-e.h / e.a, 4 * e.discriminant(), 1);
}
[[nodiscard]] inline FoundRoots b_divided_of_half(const ReducedEquation& e) {
  return roots_by(-e.h / e.a, e.discriminant(), 1);
}
[[nodiscard]] inline FoundRoots undivided(const ReducedEquation& e) {
  return roots_by(-2 * e.h, 4 * e.discriminant(), 1);
}
[[nodiscard]] inline FoundRoots undivided_half(const ReducedEquation& e) {
  return roots_by(-e.h, e.discriminant(), 1);
}
/// @}
/// One of the two roots by a wrong formula: the other is right.
template <RootFormula wrong, std::size_t which>
[[nodiscard]] FoundRoots one_by(const ReducedEquation& e) {
  FoundRoots roots = roots_by(-e.h, e.discriminant(), e.a);
  if (const FoundRoots all = wrong(e); roots && all) (*roots)[which] = (*all)[which];
  return roots;
}
/// @{ -b is halved and √D is not, or the other way round.
[[nodiscard]] inline FoundRoots b_not_halved(const ReducedEquation& e) {
  return roots_by(-2 * e.h, e.discriminant(), e.a);
}
[[nodiscard]] inline FoundRoots root_not_halved(const ReducedEquation& e) {
  return roots_by(-e.h, 4 * e.discriminant(), e.a);
}
/// @}

/// a is taken for 1; not of a sphere, where it is 1 as soon as the direction is a unit vector.
[[nodiscard]] Answers a_taken_for_one(const Case& one, const Answer& exact);

/// Of two roots of a sphere, or of an equation, whether their product is right and their sum is not: that of
/// -b ± √D which cancels was divided by a, and c by it; nothing where the sum is right.
[[nodiscard]] std::optional<bool> divides_by_what_cancels(const Case& one, const Answer& got,
                                                          const Answer& exact);

/// @{ Of two roots, or hits of one solid: one is right and the other wrong; their distance is wrong, and not
/// what lies half way between them; and the other way round.
[[nodiscard]] std::optional<bool> one_root_wrong(const Case& one, const Answer& got, const Answer& exact);
[[nodiscard]] std::optional<bool> distance_of_roots_wrong(const Case& one, const Answer& got,
                                                          const Answer& exact);
[[nodiscard]] std::optional<bool> middle_of_roots_wrong(const Case& one, const Answer& got,
                                                        const Answer& exact);
/// @}

}  // namespace rayproof::diagnosis
