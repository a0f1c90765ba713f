/// \file
/// The oracle for the quadratic equation.

#include "oracle/judge/judging.hpp"
#include "oracle/shapes/shapes.hpp"

namespace rayproof::oracle {
namespace {

template <class R>
Solved<R> solved(const Quadratic<double>& q) {
  return solve(R(q.a), R(q.b) * R(0.5), R(q.c));
}

/// |ax² + bx + c| in units of |ax²| + |bx| + |c|, the backward error of x.
template <class R>
SizeOf<R> residual_of(const Quadratic<double>& q, double x) {
  using std::abs;
  const R axx = R(q.a) * R(x) * R(x);
  const R bx = R(q.b) * R(x);
  const SizeOf<R> size = abs(approximate(axx)) + abs(approximate(bx)) + abs(SizeOf<R>(q.c));
  return ratio(abs(roughly(axx + bx + R(q.c))), size);
}

/// How near the discriminant is to 0, in units of b² + 4|ac|. No change by a share of its own makes a 0
/// another number.
Scaled margin_of(const Quadratic<double>& q) {
  if (q.a == 0 || (q.b == 0 && q.c == 0)) return endless();
  const Ring bb = Ring(q.b) * Ring(q.b);
  const Ring ac4 = Ring(4.0) * Ring(q.a) * Ring(q.c);
  return ratio(abs(approximate(bb - ac4)), approximate(bb) + abs(approximate(ac4)));
}

template <class R>
Judgement judge_over(const Quadratic<double>& equation, Precision precision,
                     const QuadraticAnswer<double>& claimed) {
  const Solved<R> exact = solved<R>(equation);
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
    note_error(judgement, precision, x, ulps,
               [&] { return in_units(residual_of<R>(equation, x), precision); });
  }
  return judgement;
}

}  // namespace

QuadraticAnswer<double> answer(const Quadratic<double>& equation, Precision precision) {
  const SolvedEquation exact = solved<Ring>(equation);
  QuadraticAnswer<double> result{exact.kind};
  for (const ExactRoot& root : exact.roots)
    result.roots.at(result.count++) = round_correctly(root, precision);
  return result;
}

Judgement judge(const Quadratic<double>& equation, Precision precision,
                const QuadraticAnswer<double>& claimed) {
  // Estimates by themselves cost half of what a ring does, whose numbers may be either.
  return Filtering::is_on ? judge_over<Estimate>(equation, precision, claimed)
                          : judge_over<Ring>(equation, precision, claimed);
}

}  // namespace rayproof::oracle
