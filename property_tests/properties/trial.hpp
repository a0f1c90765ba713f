#pragma once
/// \file
/// One subject put to one case, and what can be said of it.

#include <algorithm>
#include <cmath>
#include <optional>

#include "oracle/oracle.hpp"
#include "properties/numbers.hpp"
#include "subjects/subject.hpp"

namespace rayproof {

/// A subject and a case. The subject's answer and its judgement are computed where a property first asks for
/// them, and once only, so that properties share them.
class Trial {
 public:
  Trial(const Subject& subject, const Case& one) : subject_(&subject), case_(&one) {}

  [[nodiscard]] const Subject& subject() const { return *subject_; }
  [[nodiscard]] const Case& question() const { return *case_; }

  [[nodiscard]] const Answer& claimed() {
    if (!claimed_) claimed_ = subject_->answer(*case_);
    return *claimed_;
  }
  [[nodiscard]] const oracle::Judgement& judgement() {
    if (!judgement_) judgement_ = oracle::judge(*case_, claimed());
    return *judgement_;
  }

  /// Whether every length of the case lies in the domain of the subject's bounds, `spare` powers of two
  /// inside it.
  [[nodiscard]] bool in_domain(int spare = 0) {
    const bool every_number = subject_->contract.domain.every_number;
    return in_reach(reach() - spare) && (!every_number || all_numbers_in_reach(reach() - spare));
  }

  /// Whether every length of the case lies within 2^±reach.
  [[nodiscard]] bool in_reach(int reach) {
    return judgement().smallest >= -reach && judgement().largest <= reach;
  }

  /// Whether every number of the case that is not 0 (or an infinite end of the interval) lies within
  /// 2^±reach.
  [[nodiscard]] bool all_numbers_in_reach(int reach) const {
    Case copy = *case_;
    const auto fits = [&](const CaseNumber& number) {
      const double size = std::abs(*number.value);
      return size == 0 || !std::isfinite(size) || std::abs(std::log2(size)) <= reach;
    };
    return std::ranges::all_of(numbers_of(copy), fits);
  }

  /// The reach of the subject's domain at the case's precision. Under a transform, no further than the usual
  /// one: the way into object space is plain arithmetic, however careful the method is behind it.
  [[nodiscard]] int reach() const {
    const auto at_precision = [this](const Domain& domain) {
      return case_->precision == Precision::float32 ? domain.reach_float : domain.reach_double;
    };
    const auto* asked = std::get_if<RayQuestion>(&case_->question);
    const bool is_transformed = asked != nullptr && asked->transform.has_value();
    const int own = at_precision(subject_->contract.domain);
    return is_transformed ? std::min(own, at_precision(Domain{})) : own;
  }

 private:
  const Subject* subject_;
  const Case* case_;
  std::optional<Answer> claimed_{};
  std::optional<oracle::Judgement> judgement_{};
};

}  // namespace rayproof
