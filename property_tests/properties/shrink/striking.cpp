#include <algorithm>
#include <iterator>

#include "properties/shrink/shrink.hpp"

namespace rayproof {
namespace {

/// What a subject answers, asked all at once, to some cases and to those that the property compares them
/// with.
class TogetherAsked {
 public:
  TogetherAsked() = default;
  TogetherAsked(const Subject& subject, const Property& property, std::span<const Case> cases)
      : asked_(cases.begin(), cases.end()) {
    for (const Case& one : cases) {
      others_.push_back(asked_.size());
      if (property.asks != nullptr) std::ranges::move(property.asks(one), std::back_inserter(asked_));
    }
    others_.push_back(asked_.size());
    outcomes_.resize(asked_.size());
    subject.start()->answer(asked_, outcomes_);
  }

  /// Lets the trial of the i-th case know them; what was not asked it asks itself.
  void pass_to(Trial& trial, std::size_t i) const {
    if (outcomes_.empty() || outcomes_[i].kind == OutcomeKind::not_asked) return;
    std::vector<std::pair<const Case*, const Outcome*>> others;
    for (std::size_t k = others_[i]; k < others_[i + 1]; ++k)
      if (outcomes_[k].kind != OutcomeKind::not_asked) others.emplace_back(&asked_[k], &outcomes_[k]);
    trial.know(outcomes_[i], std::move(others));
  }

 private:
  std::vector<Case> asked_{};
  std::vector<std::size_t> others_{};  ///< where those of each case begin, and where the last end
  std::vector<Outcome> outcomes_{};
};

}  // namespace

bool shows_plainly(const Property& property, const Case& one) {
  if (property.claim != Claim::normal) return true;
  const Answer exact = oracle::answer(one);
  return std::get<RayAnswer>(exact).normal.has_value();
}

Breaking striking_break(const Subject& subject, const Property& property, Trial& as_found) {
  constexpr double striking = 100;
  const double wanted = property.excess != nullptr ? std::min(property.excess(as_found), striking) : 0;
  const bool is_plain = shows_plainly(property, as_found.question());
  const auto first = [&subject, &property, wanted,
                      is_plain](std::span<const Case> cases) -> std::optional<std::size_t> {
    const TogetherAsked answers =
        cases.size() > 1 ? TogetherAsked(subject, property, cases) : TogetherAsked();
    for (std::size_t i = 0; i < cases.size(); ++i) {
      Trial trial(subject, cases[i]);
      answers.pass_to(trial, i);
      if (ruling_of(property, trial) == Ruling::broken &&
          (property.excess == nullptr || property.excess(trial) >= wanted) &&
          (!is_plain || shows_plainly(property, cases[i])))
        return i;
    }
    return std::nullopt;
  };
  // What ends a program would end it for all that are asked together.
  return {.first = first, .at_once = property.claim == Claim::answers ? 1 : asked_at_once(subject)};
}

}  // namespace rayproof
