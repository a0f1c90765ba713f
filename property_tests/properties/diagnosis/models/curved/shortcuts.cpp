#include "properties/diagnosis/models/curved/shortcuts.hpp"

#include <algorithm>
#include <cmath>

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/examination/agreement.hpp"

namespace rayproof::diagnosis {
namespace {

using Roots = QuadraticAnswer<double>;

/// The equation of a case, a not 0; null where it has none.
const Quadratic<double>* square_in(const Case& one) {
  const auto* q = std::get_if<Quadratic<double>>(&one.question);
  return q != nullptr && q->a != 0 ? q : nullptr;
}

/// One root, whatever it is called.
Answers alone(double x) {
  Answers answers;
  for (const RootKind kind : {RootKind::linear, RootKind::twice, RootKind::two})
    answers.emplace_back(Roots{kind, 1, {x}});
  return answers;
}

/// No root, whatever it is called.
void add_none(Answers& answers) {
  for (const RootKind kind : {RootKind::none, RootKind::linear, RootKind::constant, RootKind::twice})
    answers.emplace_back(Roots{kind, 0, {}});
}

/// What is found where D, or √D, is a float, by four formulas.
Answers with_discriminant_in_float(const Case& one) {
  const std::optional<ReducedEquation> equation = reduced_equation(one);
  if (!equation) return {};
  const auto& [a, h, c] = *equation;
  Answers answers;
  const double exact = equation->discriminant(), root = double{static_cast<float>(std::sqrt(exact))};
  for (const double D :
       {double{static_cast<float>(4 * exact)} / 4, double{static_cast<float>(exact)}, root * root}) {
    for (FoundRoots roots : {roots_by(-h, D, a), without_cancelling(*equation, D)}) {
      if (roots) std::ranges::sort(*roots);
      for (Answer& answer : with_roots(one, roots)) answers.push_back(std::move(answer));
    }
  }
  return answers;
}

double farthest_of(const std::vector<double>& some, const std::vector<double>& others) {
  double worst = 0;
  for (std::size_t i = 0; i < some.size(); ++i) worst = std::max(worst, std::abs(some[i] - others[i]));
  return worst;
}

/// Whether an answer is much nearer to another one than to the exact one, or the other way round; nothing
/// where the two are nearly the same, or it is neither.
std::optional<bool> is_rather(const Case& one, const Answer& got, const Answer& other, const Answer& exact) {
  constexpr double clearly = 16;
  if (!agree(one, exact, other, Aspect::hits)) {
    const bool is_other = agree(one, got, other, Aspect::hits);
    return is_other || agree(one, got, exact, Aspect::hits) ? std::optional(is_other) : std::nullopt;
  }
  const std::vector<double> a = numbers_in(got), b = numbers_in(other), c = numbers_in(exact);
  if (a.empty() || a.size() != b.size() || a.size() != c.size()) return std::nullopt;
  const double size = std::max(std::abs(c.front()), std::abs(c.back()));
  if (!(farthest_of(b, c) > 0x1p-36 * size)) return std::nullopt;
  if (clearly * farthest_of(a, b) < farthest_of(a, c)) return true;
  return clearly * farthest_of(a, c) < farthest_of(b, c) ? std::optional(false) : std::nullopt;
}

bool is_sum_zero(const Quadratic<double>& q) { return q.a + q.b + q.c == 0; }

}  // namespace

Answers large_b_as_linear(const Case& one, const Answer& exact, double multiple) {
  const auto* q = square_in(one);
  if (q == nullptr) return {};
  const double square = q->b * q->b, limit = multiple * std::abs(q->a * q->c);
  if (q->b == 0 || !(square > limit)) return {};
  Answers answers = alone(-q->c / q->b);
  if (!(square > 4 * limit)) answers.push_back(exact);
  return answers;
}

Answers fixed_place_of(const Case& one, double root) {
  const auto* q = square_in(one);
  if (q == nullptr || (q->a * root + q->b) * root + q->c != 0) return {};
  const double other = root == 0 ? -q->b / q->a : q->c / (q->a * root);
  return {Roots{RootKind::two, 2, {root, other}}, Roots{RootKind::two, 2, {other, root}}};
}

std::optional<bool> wrong_where_sum_is_zero(const Case& one, const Answer& got, const Answer& exact) {
  const auto* q = square_in(one);
  if (q == nullptr || !is_sum_zero(*q)) return std::nullopt;
  return !agree(one, got, exact, Aspect::hits);
}

Answers linear_zero_missed(const Case& /*one*/, const Answer& exact) {
  const auto* roots = std::get_if<Roots>(&exact);
  Answers answers;
  if (roots != nullptr && roots->kind == RootKind::linear && roots->roots[0] == 0) add_none(answers);
  return answers;
}

Answers zero_missed(const Case& /*one*/, const Answer& exact) {
  const auto* roots = std::get_if<Roots>(&exact);
  if (roots == nullptr || roots->count == 0) return {};
  const auto given = std::span(roots->roots).first(roots->count);
  if (std::ranges::find(given, 0.0) == given.end()) return {};
  Answers answers;
  if (roots->count == 2) return alone(given[0] == 0 ? given[1] : given[0]);
  add_none(answers);
  return answers;
}

bool has_square(const Case& one, const Answer& /*exact*/) { return square_in(one) != nullptr; }

FoundRoots second_by_sum(const ReducedEquation& e) {
  FoundRoots roots = without_cancelling(e, e.discriminant());
  if (roots) (*roots)[1] = -2 * e.h - (*roots)[0];
  return roots;
}

FoundRoots first_by_sum(const ReducedEquation& e) {
  FoundRoots roots = without_cancelling(e, e.discriminant());
  if (roots) (*roots)[0] = -2 * e.h - (*roots)[1];
  return roots;
}

std::optional<bool> has_discriminant_in_float(const Case& one, const Answer& got, const Answer& exact) {
  if (one.precision == Precision::float32) return std::nullopt;
  std::size_t count = 0, against = 0;
  for (const Answer& foreseen : with_discriminant_in_float(one)) {
    const std::optional<bool> is_so =
        is_rather(one, got, as_reported(foreseen, got), as_reported(exact, got));
    if (is_so == true) return true;
    ++count;
    against += is_so == false ? 1 : 0;
  }
  return count > 0 && against == count ? std::optional(false) : std::nullopt;
}

}  // namespace rayproof::diagnosis
