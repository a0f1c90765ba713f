#pragma once
/// \file
/// The shrinker: from a case that breaks a property to the simplest one like it that a short search finds.

#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "properties/property.hpp"

namespace rayproof {

/// How hard a case is to read: 0 for one whose numbers could all be left out. The order is total and has no
/// endless descents (it is a natural number), so that a shrinker that only ever goes down comes to an end.
///
/// Digits beyond the third of any number weigh most, then a transform, then the digits, exponents and signs
/// of all numbers, then how many different numbers there are.
[[nodiscard]] unsigned complexity(const Case& one);

/// How many significant decimal digits `x` needs to be read back at the precision; 0 for 0 and for
/// infinities.
[[nodiscard]] unsigned significant_digits(double x, Precision precision);

/// How long to search: cases tried, and a time after which to stop in any case. Within the time the outcome
/// depends on nothing but the case and the property.
struct ShrinkBudget {
  unsigned tries = 60'000;
  std::chrono::milliseconds time{4000};
  const std::atomic<bool>* stop = nullptr;  ///< once true, what was found so far has to do
};

/// How many cases a subject is asked together: a program several, since a conversation costs more than an
/// answer.
[[nodiscard]] inline std::size_t asked_at_once(const Subject& subject) {
  return subject.function != nullptr ? 1 : 16;
}

/// Which cases still show what was found.
struct Breaking {
  /// The place of the first of some cases that does; nothing where none does.
  std::function<std::optional<std::size_t>(std::span<const Case>)> first;
  std::size_t at_once = 1;  ///< how many are asked together
};

/// The simplest case found that is valid and that still breaks. `start` itself where none is simpler: a case
/// that does not break is never returned, provided that `start` does.
///
/// It drops what can be left out, makes numbers simpler one at a time, in pairs and all at once, moves the
/// scene to the origin and scales it. A step is taken only where `complexity` goes down.
[[nodiscard]] Case shrink(const Case& start, const Breaking& breaking, const ShrinkBudget& budget = {});

/// The same for whoever is asked one case at a time.
[[nodiscard]] Case shrink(const Case& start, const std::function<bool(const Case&)>& breaks,
                          const ShrinkBudget& budget = {});

/// The valid cases that one change makes simpler, the boldest change first; a proper figure stays one.
[[nodiscard]] std::vector<Case> simpler_cases(const Case& one);

/// Whether the case format accepts the case: finite numbers, a direction, an interval, a shape and a regular
/// transform.
[[nodiscard]] bool is_valid(const Case& one);

/// Whether the case shows plainly what breaks the property: of a normal where the exact answer has one, off
/// the edges, on which several are right.
[[nodiscard]] bool shows_plainly(const Property& property, const Case& one);

/// What a shrunk case must still do: break the property, and do so strikingly, at least a hundred times over
/// the bound or as badly as the trial that was found. A case only just over a bound shows nothing to a
/// reader.
[[nodiscard]] Breaking striking_break(const Subject& subject, const Property& property, Trial& as_found);

}  // namespace rayproof
