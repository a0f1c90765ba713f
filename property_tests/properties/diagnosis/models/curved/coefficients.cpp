#include "properties/diagnosis/models/curved/coefficients.hpp"

#include <algorithm>

#include "properties/diagnosis/models/curved/root_formula.hpp"

namespace rayproof::diagnosis {
namespace {

using Equation = Quadratic<double>;

std::optional<ReducedEquation> equation_of_sphere(const Case& one) {
  return shape_in<Sphere<double>>(one) == nullptr ? std::nullopt : reduced_equation(one);
}

}  // namespace

Answers missed_with_zero_coefficient(const Case& one, const Answer& exact) {
  const auto equation = equation_of_sphere(one);
  if (!equation) return {};
  Answers answers;
  for (const bool is_zero : {equation->h == 0, equation->h == 0 || equation->c == 0})
    answers.push_back(is_zero ? Answer{RayAnswer{}} : exact);
  return answers;
}

bool has_no_linear_term(const Case& one, const Answer& /*exact*/) {
  const auto equation = equation_of_sphere(one);
  return equation && equation->h == 0;
}

Answers a_as_one_by_length(const Case& one, const Answer& exact) {
  const auto equation = equation_of_sphere(one);
  if (!equation) return {};
  Answers answers;
  for (const bool is_taken : {equation->a<1, equation->a> 1})
    answers.push_back(
        is_taken ? with_roots(one, roots_by(-equation->h, equation->h * equation->h - equation->c, 1)).front()
                 : exact);
  return answers;
}

Answers half_b_made_whole(const Case& one, const Answer& exact) {
  const auto* given = std::get_if<Equation>(&one.question);
  if (given == nullptr || given->a == 0) return {};
  Answers answers;
  for (const bool is_cut_off : {false, true}) {
    Case changed = one;
    double& b = std::get<Equation>(changed.question).b;
    b = 2 * (is_cut_off ? std::trunc(b / 2) : std::floor(b / 2));
    const std::vector<Case> valid = if_finite(std::move(changed));
    answers.push_back(valid.empty() ? exact : oracle::answer(valid.front()));
  }
  return answers;
}

Answers root_beside_zero(const Case& one, const Answer& /*exact*/) {
  const auto* given = std::get_if<Equation>(&one.question);
  if (given == nullptr || given->c != 0 || given->a == 0 || given->b == 0) return {};
  Answers answers;
  for (const double root : {-given->b, given->b / given->a, -given->b / (2 * given->a)})
    answers.emplace_back(
        QuadraticAnswer<double>{RootKind::two, 2, {std::min(root, 0.0), std::max(root, 0.0)}});
  return answers;
}

namespace {

/// Whether -b ± √D loses the smaller root, and with it what c is.
bool is_c_lost_by_cancelling(Precision precision, const Equation& e) {
  const double digits = precision == Precision::float32 ? 0x1p-22 : 0x1p-51;
  return 4 * std::abs(e.a * e.c) < digits * e.b * e.b;
}

}  // namespace

std::vector<Case> with_small_as_zero(const Case& one, double Equation::*small, double least) {
  Case changed = one;
  auto* equation = std::get_if<Equation>(&changed.question);
  if (equation != nullptr && small == &Equation::c && is_c_lost_by_cancelling(one.precision, *equation))
    return {};
  if (equation == nullptr || equation->*small == 0 || !(std::abs(equation->*small) < least)) return {};
  equation->*small = 0;
  return if_finite(std::move(changed));
}

}  // namespace rayproof::diagnosis
