#include "properties/shrink/shrink.hpp"

#include <algorithm>

#include "properties/shrink/moves.hpp"
#include "properties/shrink/simplicity.hpp"
#include "properties/shrink/validity.hpp"

namespace rayproof {

namespace {

/// The simplest case so far, and what is left of the budget.
class Search {
 public:
  Search(const Case& start, const std::function<bool(const Case&)>& breaks, const ShrinkBudget& budget)
      : best_(start),
        complexity_(complexity(start)),
        stays_proper_(is_proper(start)),
        breaks_(breaks),
        tries_left_(budget.tries),
        stop_(budget.stop),
        end_(std::chrono::steady_clock::now() + budget.time) {}

  [[nodiscard]] const Case& best() const { return best_; }

  /// Takes the candidate if it is simpler, valid, and still breaks; says so.
  bool consider(const Case& candidate) {
    const unsigned how_complex = complexity(candidate);
    if (how_complex >= complexity_ || is_over() || !is_valid(candidate)) return false;
    if (stays_proper_ && !is_proper(candidate)) return false;
    --tries_left_;
    if (!breaks_(candidate)) return false;
    best_ = candidate;
    complexity_ = how_complex;
    return true;
  }

  [[nodiscard]] bool is_over() const {
    return tries_left_ == 0 || (stop_ != nullptr && *stop_) ||
           (tries_left_ % 64 == 0 && std::chrono::steady_clock::now() > end_);
  }

 private:
  Case best_;
  unsigned complexity_;
  bool stays_proper_;
  const std::function<bool(const Case&)>& breaks_;
  unsigned tries_left_;
  const std::atomic<bool>* stop_;
  std::chrono::steady_clock::time_point end_;
};

}  // namespace

Case shrink(const Case& start, const std::function<bool(const Case&)>& breaks, const ShrinkBudget& budget) {
  Search search(start, breaks, budget);
  const shrink_moves::Try attempt = [&](const Case& candidate) { return search.consider(candidate); };
  for (bool improved = true; improved && !search.is_over();) {
    improved = false;
    for (const auto move : shrink_moves::all) improved = move(search.best(), attempt) || improved;
  }
  return search.best();
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
