#include "oracle/shapes/quadratic.hpp"

#include <array>

#include "oracle/judge/judging.hpp"

namespace rayproof::oracle {
namespace {

ExactQuadratic exact_form(const Quadratic<double>& q) {
  return ExactQuadratic::opening_upwards(Ring(q.a), Ring(q.b) * Ring(0.5), Ring(q.c));
}

RootKind kind_of(const Quadratic<double>& q, const ExactQuadratic& form) {
  if (q.a == 0 && q.b == 0) return q.c == 0 ? RootKind::everything : RootKind::constant;
  if (q.a == 0) return RootKind::linear;
  const int discriminant = sign(form.discriminant());
  if (discriminant < 0) return RootKind::none;
  return discriminant == 0 ? RootKind::twice : RootKind::two;
}

std::size_t count_of(RootKind kind) {
  if (kind == RootKind::two) return 2;
  return kind == RootKind::twice || kind == RootKind::linear ? 1 : 0;
}

/// |ax² + bx + c| in units of ε(|ax²| + |bx| + |c|), the backward error of x.
double residual(const Quadratic<double>& q, double x, double epsilon) {
  const Ring axx = Ring(q.a) * Ring(x) * Ring(x);
  const Ring bx = Ring(q.b) * Ring(x);
  const Scaled size = abs(approximate(axx)) + abs(approximate(bx)) + abs(Scaled(q.c));
  if (size.sign() == 0) return 0;
  return static_cast<double>((abs(approximate(axx + bx + Ring(q.c))) / (Scaled(epsilon) * size)).value());
}

/// How near the discriminant is to 0, in units of ε(b² + 4|ac|).
double margin_of(const Quadratic<double>& q, double epsilon) {
  const Ring bb = Ring(q.b) * Ring(q.b);
  const Ring ac4 = Ring(4.0) * Ring(q.a) * Ring(q.c);
  const Scaled size = approximate(bb) + abs(approximate(ac4));
  if (size.sign() == 0) return 0;
  return static_cast<double>((abs(approximate(bb - ac4)) / (Scaled(epsilon) * size)).value());
}

}  // namespace

QuadraticAnswer<double> answer(const Quadratic<double>& equation, Precision precision) {
  const ExactQuadratic form = exact_form(equation);
  QuadraticAnswer<double> result{kind_of(equation, form)};
  for (std::size_t i = 0; i < count_of(result.kind); ++i) {
    result.roots.at(result.count++) = round_correctly(ExactRoot(form, i == 0 ? -1 : 1), precision);
  }
  return result;
}

Judgement judge(const Quadratic<double>& equation, Precision precision,
                const QuadraticAnswer<double>& claimed) {
  const ExactQuadratic form = exact_form(equation);
  const RootKind kind = kind_of(equation, form);
  const double epsilon = unit_roundoff(precision);
  Judgement judgement;
  note_range(std::array{equation.a, equation.b, equation.c}, judgement);
  judgement.hit = count_of(kind) > 0;
  judgement.wrong = kind != claimed.kind || claimed.count != count_of(kind);
  if (judgement.wrong) {
    judgement.margin = equation.a == 0 ? HUGE_VAL : margin_of(equation, epsilon);
    judgement.ulp = std::nan("");
  }
  for (std::size_t i = 0; i < claimed.count; ++i) {
    const double x = claimed.roots.at(i);
    const double ulps =
        judgement.wrong ? HUGE_VAL : error_in_ulps(ExactRoot(form, i == 0 ? -1 : 1), x, precision);
    if (!judgement.wrong) judgement.ulp = std::max(judgement.ulp, ulps);
    if (is_best_on_grid(x, ulps, precision)) continue;
    judgement.residual =
        std::max(judgement.residual, std::isfinite(x) ? residual(equation, x, epsilon) : HUGE_VAL);
  }
  return judgement;
}

}  // namespace rayproof::oracle
