#pragma once
/// \file
/// The oracle: exact answers to cases, and exact judgement of other people's answers. Slow, final, and
/// independent of every method it judges: it shares the case, never a formula.

#include "case/answer.hpp"
#include "case/case.hpp"

namespace rayproof::oracle {

/// What the exact truth says of a claimed answer. Lengths are in the units of the topic's contract
/// (sphere.hpp, quadratic.hpp) with far_power 0. A verdict error and an ulp error are different things and
/// stay apart.
struct Judgement {
  /// The claimed number of hits (or kind of roots) is not the exact one.
  bool wrong = false;
  /// The case was a hit (or had roots) in truth: distinguishes a wrong miss from a wrong hit.
  bool hit = false;
  /// How near the case is to a change of verdict: 0 on the edge; computed only where `wrong`.
  double margin = 0;
  /// The worst residual of the claimed hits; 0 where there are none.
  double residual = 0;
  /// The worst error of the claimed hits, in ulps of the exact t at the case's precision; NaN where `wrong`.
  double ulp = 0;
  /// The ratio by which naive methods degrade: S/radius of a sphere or a cylinder, 1/steepness of a triangle
  /// (triangle.hpp), 1 over the volume of unit edges of a parallelepiped, 1 of the rest and where nothing is
  /// wrong and nothing was hit.
  double far = 1;
  /// log2 of the smallest and the largest length the domain of a contract speaks of.
  double smallest = 0;
  double largest = 0;
};

/// The exact answer of a valid case, rounded once at the end as the case format says.
[[nodiscard]] Answer answer(const Case& one);

/// Judges `claimed` against the exact truth of `one`. Certain in every bit that decides a verdict; errors are
/// certain to 2^-20 of their value or 2^-30 ulp, whichever is larger.
[[nodiscard]] Judgement judge(const Case& one, const Answer& claimed);

}  // namespace rayproof::oracle
