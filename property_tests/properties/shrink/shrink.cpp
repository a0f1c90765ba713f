#include "properties/shrink/shrink.hpp"

#include <algorithm>

#include "properties/shrink/moves.hpp"
#include "properties/shrink/simplicity.hpp"
#include "properties/shrink/validity.hpp"

namespace rayproof {

namespace {

/// What may take the place of a case: one below its complexity that is valid, and a proper figure for a
/// proper one.
struct Simpler {
  unsigned limit;
  bool stays_proper;

  explicit Simpler(const Case& than) : limit(complexity(than)), stays_proper(is_proper(than)) {}

  [[nodiscard]] bool admits(const Case& candidate) const {
    return complexity(candidate) < limit && is_valid(candidate) && (!stays_proper || is_proper(candidate));
  }
};

}  // namespace

Case shrink(const Case& start, const std::function<bool(const Case&)>& breaks, const ShrinkBudget& budget) {
  Case best = start;
  Simpler simpler(start);
  bool improved = true;
  unsigned tries_left = budget.tries;
  const auto end = std::chrono::steady_clock::now() + budget.time;
  const auto is_over = [&] {
    return tries_left == 0 || (budget.stop != nullptr && *budget.stop) ||
           (tries_left % 64 == 0 && std::chrono::steady_clock::now() > end);
  };
  const auto consider = [&](const Case& candidate) {
    if (!simpler.admits(candidate) || is_over()) return;
    --tries_left;
    if (!breaks(candidate)) return;
    best = candidate;
    simpler.limit = complexity(candidate);
    improved = true;
  };
  while (improved && !is_over()) {
    improved = false;
    for (const auto move : shrink_moves::all) move(best, consider);
  }
  return best;
}

std::vector<Case> simpler_cases(const Case& one) {
  std::vector<Case> all;
  const Simpler simpler(one);
  const auto keep = [&](const Case& candidate) {
    if (simpler.admits(candidate)) all.push_back(candidate);
  };
  for (const auto move : shrink_moves::all) move(one, keep);
  return all;
}

std::function<bool(const Case&)> striking_break(const Subject& subject, const Property& property,
                                                Trial& as_found) {
  constexpr double striking = 100;
  const double wanted = property.excess != nullptr ? std::min(property.excess(as_found), striking) : 0;
  return [&subject, &property, wanted](const Case& candidate) {
    Trial trial(subject, candidate);
    return property.rule(trial) == Ruling::broken &&
           (property.excess == nullptr || property.excess(trial) >= wanted);
  };
}

}  // namespace rayproof
