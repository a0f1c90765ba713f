#include "properties/diagnosis/models/curved/quadratic.hpp"

#include <algorithm>
#include <cmath>

#include "properties/diagnosis/examination/agreement.hpp"
#include "properties/diagnosis/models/curved/root_formula.hpp"

namespace rayproof::diagnosis {
namespace {

using Roots2 = QuadraticAnswer<double>;

/// What the textbook formula gives with another discriminant.
Answers with_discriminant(const Case& one, double D) {
  const auto* q = std::get_if<Quadratic<double>>(&one.question);
  if (q == nullptr || q->a == 0) return {};
  if (D < 0) return {Roots2{RootKind::none, 0, {}}};
  const double s = std::sqrt(D), x = (-q->b - s) / (2 * q->a), y = (-q->b + s) / (2 * q->a);
  if (D == 0) return {Roots2{RootKind::twice, 1, {x}}};
  return {Roots2{RootKind::two, 2, {std::min(x, y), std::max(x, y)}}};
}

std::optional<bool> is_wrong_where(RootKind kind, const Case& one, const Answer& got, const Answer& exact) {
  const auto* roots = std::get_if<Roots2>(&exact);
  if (roots == nullptr || roots->kind != kind) return std::nullopt;
  return !agree(one, got, exact, Aspect::hits);
}

}  // namespace

std::optional<bool> wrong_where_linear(const Case& one, const Answer& got, const Answer& exact) {
  return is_wrong_where(RootKind::linear, one, got, exact);
}

std::optional<bool> wrong_where_double(const Case& one, const Answer& got, const Answer& exact) {
  return is_wrong_where(RootKind::twice, one, got, exact);
}

std::optional<bool> wrong_where_constant(const Case& one, const Answer& got, const Answer& exact) {
  return is_wrong_where(RootKind::constant, one, got, exact);
}

std::optional<bool> wrong_where_all_is_zero(const Case& one, const Answer& got, const Answer& exact) {
  return is_wrong_where(RootKind::everything, one, got, exact);
}

std::optional<bool> wrong_where_c_is_zero(const Case& one, const Answer& got, const Answer& exact) {
  const auto* q = std::get_if<Quadratic<double>>(&one.question);
  if (q == nullptr || q->c != 0 || q->a == 0) return std::nullopt;
  return !agree(one, got, exact, Aspect::hits);
}

std::optional<bool> wrong_where_b_is_zero(const Case& one, const Answer& got, const Answer& exact) {
  const auto* q = std::get_if<Quadratic<double>>(&one.question);
  if (q == nullptr || q->b != 0 || q->a == 0) return std::nullopt;
  return !agree(one, got, exact, Aspect::hits);
}

std::optional<bool> wrong_where_square(const Case& one, const Answer& got, const Answer& exact) {
  const auto* q = std::get_if<Quadratic<double>>(&one.question);
  if (q == nullptr || q->b != 0 || q->c != 0 || q->a == 0) return std::nullopt;
  return !agree(one, got, exact, Aspect::hits);
}

Answers double_root_missed(const Case& /*one*/, const Answer& exact) {
  const auto* roots = std::get_if<Roots2>(&exact);
  if (roots == nullptr || roots->kind != RootKind::twice) return {};
  return {Roots2{RootKind::none, 0, {}}};
}

Answers discriminant_without_sign(const Case& one, const Answer& exact) {
  const auto* q = std::get_if<Quadratic<double>>(&one.question);
  const auto* roots = std::get_if<Roots2>(&exact);
  if (roots == nullptr || roots->kind != RootKind::none) return {};
  Answers answers = with_discriminant(one, std::abs(q->b * q->b - 4 * q->a * q->c));
  const ReducedEquation equation = *reduced_equation(one);
  for (Answer& other : with_roots(one, without_cancelling(equation, -equation.discriminant())))
    answers.push_back(std::move(other));
  return answers;
}

Answers linear_root_negated(const Case& /*one*/, const Answer& exact) {
  const auto* roots = std::get_if<Roots2>(&exact);
  if (roots == nullptr || roots->kind != RootKind::linear) return {};
  return {Roots2{RootKind::linear, 1, {-roots->roots[0]}}};
}

Answers linear_root_inverted(const Case& /*one*/, const Answer& exact) {
  const auto* roots = std::get_if<Roots2>(&exact);
  if (roots == nullptr || roots->kind != RootKind::linear || roots->roots[0] == 0) return {};
  return {Roots2{RootKind::linear, 1, {1 / roots->roots[0]}}};
}

std::vector<Case> with_small_a_as_zero(const Case& one, double least) {
  const auto* equation = std::get_if<Quadratic<double>>(&one.question);
  if (equation == nullptr || !(std::abs(equation->a) < least)) return {};
  return with_coefficients(one, [](Quadratic<double>& changed) { changed.a = 0; });
}

std::vector<Case> with_coefficients(const Case& one, void (*change)(Quadratic<double>& equation)) {
  Case changed = one;
  auto* equation = std::get_if<Quadratic<double>>(&changed.question);
  if (equation == nullptr) return {};
  change(*equation);
  return if_finite(std::move(changed));
}

Answers double_root_times(const Answer& exact, double factor) {
  const auto* roots = std::get_if<Roots2>(&exact);
  if (roots == nullptr || roots->kind != RootKind::twice) return {};
  return {Roots2{RootKind::twice, 1, {factor * roots->roots[0]}}};
}

Answers double_root_undivided(const Case& one, const Answer& exact) {
  const auto* q = std::get_if<Quadratic<double>>(&one.question);
  if (q == nullptr) return {};
  Answers answers = double_root_times(exact, q->a);
  for (const double factor : {2 * q->a, q->a * q->a})
    for (Answer& answer : double_root_times(exact, factor)) answers.push_back(std::move(answer));
  return answers;
}

Answers positive_roots_alone(const Case& /*one*/, const Answer& exact) {
  const auto* roots = std::get_if<Roots2>(&exact);
  if (roots == nullptr || roots->count == 0 || (roots->count == 1 && roots->roots[0] >= 0)) return {};
  const Answer none = Roots2{RootKind::none, 0, {}};
  if (roots->count == 1) return {none, exact};  // it may look at two roots alone
  if (roots->roots[1] < 0) return {none};
  if (roots->roots[0] >= 0) return {};
  Answers answers;
  for (const RootKind kind : {RootKind::twice, RootKind::two, RootKind::linear})
    answers.emplace_back(Roots2{kind, 1, {roots->roots[1]}});
  return answers;
}

Answers real_part(const Case& one, const Answer& exact) {
  const auto* q = std::get_if<Quadratic<double>>(&one.question);
  const auto* roots = std::get_if<Roots2>(&exact);
  if (q == nullptr || roots == nullptr || roots->kind != RootKind::none) return {};
  const double x = -q->b / (2 * q->a);
  return {Roots2{RootKind::twice, 1, {x}}, Roots2{RootKind::two, 2, {x, x}}, Roots2{RootKind::two, 1, {x}}};
}

}  // namespace rayproof::diagnosis
