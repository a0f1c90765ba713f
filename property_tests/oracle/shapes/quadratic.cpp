/// \file
/// The oracle for the quadratic equation.

#include "oracle/judge/judging.hpp"
#include "oracle/shapes/shapes.hpp"

namespace rayproof::oracle {
namespace {

SolvedEquation solved(const Quadratic<double>& q) {
  return solve(Ring(q.a), Ring(q.b) * Ring(0.5), Ring(q.c));
}

/// |ax² + bx + c| in units of |ax²| + |bx| + |c|, the backward error of x.
Scaled residual_of(const Quadratic<double>& q, double x) {
  const Ring axx = Ring(q.a) * Ring(x) * Ring(x);
  const Ring bx = Ring(q.b) * Ring(x);
  const Scaled size = abs(approximate(axx)) + abs(approximate(bx)) + abs(Scaled(q.c));
  return ratio(abs(roughly(axx + bx + Ring(q.c))), size);
}

/// How near the discriminant is to 0, in units of b² + 4|ac|. No change by a share of its own makes a 0
/// another number.
Scaled margin_of(const Quadratic<double>& q) {
  if (q.a == 0 || (q.b == 0 && q.c == 0)) return endless();
  const Ring bb = Ring(q.b) * Ring(q.b);
  const Ring ac4 = Ring(4.0) * Ring(q.a) * Ring(q.c);
  return ratio(abs(approximate(bb - ac4)), approximate(bb) + abs(approximate(ac4)));
}

}  // namespace

QuadraticAnswer<double> answer(const Quadratic<double>& equation, Precision precision) {
  const SolvedEquation exact = solved(equation);
  QuadraticAnswer<double> result{exact.kind};
  for (const ExactRoot& root : exact.roots)
    result.roots.at(result.count++) = round_correctly(root, precision);
  return result;
}

Judgement judge(const Quadratic<double>& equation, Precision precision,
                const QuadraticAnswer<double>& claimed) {
  const SolvedEquation exact = solved(equation);
  Judgement judgement;
  Magnitudes coefficients;
  for (const double x : {equation.a, equation.b, equation.c}) coefficients.note(x);
  coefficients.put(judgement);
  judgement.hit = !exact.roots.empty();
  judgement.wrong = exact.kind != claimed.kind || claimed.count != exact.roots.size();
  if (judgement.wrong) {
    judgement.margin = in_units(margin_of(equation), precision);
    judgement.ulp = std::nan("");
  }
  for (std::size_t i = 0; i < claimed.count; ++i) {
    const double x = claimed.roots.at(i);
    const double ulps = judgement.wrong ? HUGE_VAL : error_in_ulps(exact.roots[i], x, precision);
    note_error(judgement, precision, x, ulps, [&] { return in_units(residual_of(equation, x), precision); });
  }
  return judgement;
}

}  // namespace rayproof::oracle
