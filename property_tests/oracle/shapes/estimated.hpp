#pragma once
/// \file
/// The quick judgement of a ray's claim: by estimates alone, which nearly always decide.

#include <optional>

#include "oracle/judge/judging.hpp"
#include "oracle/shapes/shapes.hpp"

namespace rayproof::oracle {

/// Lengths whose log2 is as far as this from 0 are left to exact numbers: the sizes of a judgement are
/// products and quotients of less than 60 lengths, and a long double has room for 2^±16383. (Estimates are in
/// doubles, and know themselves where these overflow.)
inline constexpr double longest_estimated = 200;

/// The judgement, or nothing where it needs more: of a wrong verdict, whose margin asks for more digits, and
/// of lengths out of reach. Throws Undecided where an estimate is not enough.
///
/// A Meeting is the ray's line and the shape over Estimate: ray(), hits(), measure(), which takes the sizes,
/// and after it far() and residual(t).
template <class Meeting, class Shape>
[[nodiscard]] std::optional<Judgement> judge_by_estimates(const RayQuestion& question, const Shape& shape,
                                                          Precision precision, const RayAnswer& claimed) {
  Magnitudes lengths;
  note_lengths(lengths, question, shape);
  if (!lengths.are_within(longest_estimated)) return std::nullopt;
  Meeting meeting(question, shape);
  const auto hits = meeting.hits();
  if (is_wrong_count(hits.size(), claimed)) return std::nullopt;
  Judgement judgement;
  if (meeting.ray().map) lengths.note(value(size_of_inverse(meeting.ray())));
  lengths.put(judgement);
  judgement.hit = !hits.empty();
  if (claimed.hits.count == 0) return judgement;
  meeting.measure();
  judgement.far = meeting.far();
  note_errors(judgement, hits, precision, claimed, [&](double t) { return meeting.residual(t); });
  return judgement;
}

/// By estimates where they are enough.
template <class Meeting, class Shape>
[[nodiscard]] Judgement judge_quickly(const RayQuestion& question, const Shape& shape, Precision precision,
                                      const RayAnswer& claimed) {
  try {
    if (const auto quick = judge_by_estimates<Meeting>(question, shape, precision, claimed)) return *quick;
  } catch (const Undecided&) {
  }
  return judge(*intersection_of(question, shape), precision, claimed);
}

}  // namespace rayproof::oracle
