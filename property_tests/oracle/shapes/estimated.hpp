#pragma once
/// \file
/// The quick judgement of a ray's claim: by estimates alone, which nearly always decide.

#include <optional>

#include "oracle/judge/judging.hpp"
#include "oracle/numbers/fused.hpp"
#include "oracle/shapes/shapes.hpp"

namespace rayproof::oracle {

/// Lengths whose log2 is as far as this from 0 are left to exact numbers: the sizes of a judgement are
/// products and quotients of less than 60 lengths, and a long double has room for 2^±16383. (Estimates are in
/// doubles, and know themselves where these overflow.)
inline constexpr double longest_estimated = 200;

/// The judgement, or nothing where it needs more: where an estimate is not enough, which is noted, of a wrong
/// verdict, which has a margin, and of lengths out of reach.
///
/// A Meeting is the ray's line and the shape over Estimate: ray(), hits(), measure(), which takes the sizes,
/// and after it far() and residual(t).
template <class Meeting, class Shape>
[[nodiscard]] std::optional<Judgement> judge_by_estimates(const RayQuestion& question, const Shape& shape,
                                                          Precision precision, const RayAnswer& claimed) {
  Doubt::clear();
  Magnitudes lengths;
  note_lengths(lengths, question, shape);
  if (!lengths.are_within(longest_estimated)) return std::nullopt;
  Meeting meeting(question, shape);
  const auto hits = meeting.hits();
  if (Doubt::is_noted() || is_wrong_count(hits.size(), claimed)) return std::nullopt;
  Judgement judgement;
  if (meeting.ray().map) lengths.note(value(size_of_inverse(meeting.ray())));
  lengths.put(judgement);
  judgement.hit = !hits.empty();
  if (claimed.hits.count > 0) {
    meeting.measure();
    judgement.far = meeting.far();
    note_errors(judgement, hits, precision, claimed, [&](double t) { return meeting.residual(t); });
  }
  return Doubt::is_noted() ? std::nullopt : std::optional(judgement);
}

/// By estimates where they are enough; what the quick judgement leaves out is nearly always decided by
/// estimates, too.
template <class Meeting, class Shape>
[[nodiscard]] Judgement judge_quickly(const RayQuestion& question, const Shape& shape, Precision precision,
                                      const RayAnswer& claimed) {
  const auto quick =
      with_fused_products([&] { return judge_by_estimates<Meeting>(question, shape, precision, claimed); });
  if (quick) return *quick;
  const auto judged = [&] { return judge(*intersection_of(question, shape), precision, claimed); };
  return Doubt::is_noted() ? judged() : filtered(judged);
}

}  // namespace rayproof::oracle
