#include "properties/diagnosis/models/curved/wrong_roots.hpp"

#include <algorithm>

#include "properties/claims/answers.hpp"

namespace rayproof::diagnosis {
namespace {

Answer with_roots_in_order(const Case& one, FoundRoots roots) {
  if (roots) std::ranges::sort(*roots);
  return with_roots(one, roots).front();
}

/// q / a and c / q, each times a factor.
FoundRoots stable_times(const ReducedEquation& e, double first, double second) {
  FoundRoots roots = without_cancelling(e, e.discriminant());
  if (roots) *roots = {first * (*roots)[0], second * (*roots)[1]};
  return roots;
}

bool differ_clearly(double x, double y, double size) {
  return !(std::abs(x - y) <= 0x1p-10 * std::max(size, std::abs(y)));
}

}  // namespace

Answers wrong_discriminant(const Case& one, const Answer& /*exact*/) {
  const std::optional<ReducedEquation> equation = reduced_equation(one);
  if (!equation) return {};
  const double a = equation->a, b = 2 * equation->h, c = equation->c;
  Answers all;
  const auto add = [&](const FoundRoots& roots) { all.push_back(with_roots_in_order(one, roots)); };
  for (const double D : {b * b * b - 4 * a * c, b - 4 * a * c, 2 * b - 4 * a * c, b * b - 4 * a,
                         b * b - 8 * a * c, 4 * a * c - b * b, b * b}) {
    add(roots_by(-b, D, 2 * a));
    add(without_cancelling(*equation, D / 4));
  }
  add(roots_by(-b, b * b - 4 * c, 2 * a));
  // Of a ray c / q is then what a direction taken for a unit vector gives.
  const bool is_equation = std::holds_alternative<Quadratic<double>>(one.question);
  all.push_back(is_equation ? with_roots_in_order(one, without_cancelling(*equation, b * b / 4 - c))
                            : all.back());
  return all;
}

FoundRoots both_divided_by_a(const ReducedEquation& e) {
  FoundRoots roots = without_cancelling(e, e.discriminant());
  if (roots) (*roots)[1] = e.c / e.a;
  return roots;
}

FoundRoots first_root_negated(const ReducedEquation& e) { return stable_times(e, -1, 1); }
FoundRoots second_root_negated(const ReducedEquation& e) { return stable_times(e, 1, -1); }

FoundRoots first_doubled(const ReducedEquation& e) { return stable_times(e, 2, 1); }
FoundRoots second_doubled(const ReducedEquation& e) { return stable_times(e, 1, 2); }
FoundRoots first_halved(const ReducedEquation& e) { return stable_times(e, 0.5, 1); }
FoundRoots second_halved(const ReducedEquation& e) { return stable_times(e, 1, 0.5); }

FoundRoots first_upside_down(const ReducedEquation& e) {
  FoundRoots roots = without_cancelling(e, e.discriminant());
  if (roots) (*roots)[0] = 1 / (*roots)[0];
  return roots;
}
FoundRoots second_upside_down(const ReducedEquation& e) {
  FoundRoots roots = without_cancelling(e, e.discriminant());
  if (roots) (*roots)[1] = 1 / (*roots)[1];
  return roots;
}

FoundRoots first_undivided(const ReducedEquation& e) {
  FoundRoots roots = roots_by(-e.h, e.discriminant(), e.a);
  if (roots) (*roots)[0] *= e.a;
  return roots;
}
FoundRoots second_undivided(const ReducedEquation& e) {
  FoundRoots roots = roots_by(-e.h, e.discriminant(), e.a);
  if (roots) (*roots)[1] *= e.a;
  return roots;
}

Answers pure_square_negated(const Case& one, const Answer& /*exact*/) {
  const auto* q = std::get_if<Quadratic<double>>(&one.question);
  if (q == nullptr || q->a == 0 || q->b != 0 || q->c == 0) return {};
  if (q->c / q->a < 0) return {QuadraticAnswer<double>{RootKind::none, 0, {}}};
  const double root = std::sqrt(q->c / q->a);
  return {QuadraticAnswer<double>{RootKind::two, 2, {-root, root}}};
}

Answers sign_of_zero(const Case& one, const Answer& exact) {
  const std::optional<ReducedEquation> equation = reduced_equation(one);
  if (!equation || equation->h != 0) return {};
  Answers all;
  const bool is_of_ray = ray_question(one) != nullptr;
  if (is_of_ray && !(equation->discriminant() > 0)) return {};
  for (const RootKind kind :
       {RootKind::linear, RootKind::twice, RootKind::two})  // 0 alone, whatever it is called
    if (!is_of_ray) all.emplace_back(QuadraticAnswer<double>{kind, 1, {0}});
  if (!(equation->discriminant() > 0)) {
    all.push_back(exact);  // D may be asked before
    return all;
  }
  for (const double other : {0.0, infinity<double>, -infinity<double>})
    all.push_back(with_roots_in_order(one, std::array{0.0, other}));
  return all;
}

std::optional<bool> number_q_wrong(const Case& one, const Answer& got, const Answer& exact) {
  const auto* q = std::get_if<Quadratic<double>>(&one.question);
  const std::vector<double> found = numbers_in(got);
  if (q == nullptr || q->a == 0 || found.size() != 2) return std::nullopt;
  const double x = found[0], y = found[1], larger = std::max(std::abs(x), std::abs(y));
  if (!differ_clearly(x + y, -q->b / q->a, larger)) return std::nullopt;
  if (divides_by_what_cancels(one, got, exact) == true) return std::nullopt;
  return !differ_clearly(x * y, q->c / q->a, 0);
}

}  // namespace rayproof::diagnosis
