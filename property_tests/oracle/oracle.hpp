#pragma once
/// \file
/// The oracle: exact answers to cases, and exact judgement of other people's answers. Slow, final, and
/// independent of every method it judges: it shares the case, never a formula.

#include <optional>

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

/// What the exact truth says of an answer's first hit beside t: of its point, normal and barycentric
/// coordinates, each nothing where there is none to judge, and infinite where one is missing or no number.
///
/// Point and normal are judged where the answer itself says that it hits, at the claimed t: how far p(t) is
/// from a hit is the residual, and at a grazing ray neither can be near the exact hit. Lengths are in units
/// of ε times the lengths that p(t) is made of, |origin| + |t||direction|, of the surface also the shape's
/// own (L(t) of the contracts); a transform makes them larger by its condition.
struct Details {
  std::optional<double> point{};    ///< how far the point is from p(t), and so from the ray
  std::optional<double> surface{};  ///< how far it is from the surface
  std::optional<double> forward{};  ///< how far it is from the exact hit; nothing where that is a miss
  /// The sine of the angle between the normal and the outward (or given) one of the surface at p(t), 1 from a
  /// right angle on, in units of ε times the condition of that normal; of several faces the one that fits
  /// best, or how much farther from p(t) it is than the nearest, whichever is more. Also how far from 1 its
  /// length is, in units of ε. Without a normal, how far p(t) is from an edge.
  std::optional<double> normal{};
  /// The largest error of a triangle's [α, β, γ] at the exact hit, in units of ε; of a parametric plane's [α,
  /// β], where they are given.
  std::optional<double> coordinates{};
  /// The same where the error of a coordinate beyond 1 counts in parts of it: what rounding leaves.
  std::optional<double> rounded_coordinates{};
  /// Whether those that a method computes, a triangle's β and γ or a plane's α and β, are the exact ones
  /// rounded once; α = 1 - β - γ of a triangle may be rounded again.
  bool coordinates_are_rounded = true;
  double condition = 1;              ///< of the coordinates: what plain methods may be off by
  std::optional<Contact> contact{};  ///< how the exact first hit touches
};

/// The exact answer of a valid case, rounded once at the end as the case format says.
[[nodiscard]] Answer answer(const Case& one);

/// Judges `claimed` against the exact truth of `one`. Certain in every bit that decides a verdict; errors are
/// certain to 2^-20 of their value or 2^-30 ulp, whichever is larger.
[[nodiscard]] Judgement judge(const Case& one, const Answer& claimed);

/// Judges what `claimed` says of its first hit beside t. It costs about as much as `judge`, and is not part
/// of it. Nothing is judged of questions that are not of a ray.
[[nodiscard]] Details judge_details(const Case& one, const Answer& claimed);

}  // namespace rayproof::oracle
