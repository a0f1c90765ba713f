#pragma once
/// \file
/// One subject asked one case, and what can be said of it.

#include <algorithm>
#include <cmath>
#include <optional>

#include "oracle/oracle.hpp"
#include "properties/numbers.hpp"
#include "subjects/subject.hpp"

namespace rayproof {

/// Whether a map stands between the case's ray and its shape.
[[nodiscard]] inline bool is_transformed(const Case& one) {
  const auto* asked = std::get_if<RayQuestion>(&one.question);
  return asked != nullptr && asked->transform;
}

/// The case asked of the whole line in place of the ray's interval.
[[nodiscard]] inline Case on_whole_line(Case one) {
  if (auto* asked = std::get_if<RayQuestion>(&one.question)) {
    asked->ray.t_min = -infinity<double>;
    asked->ray.t_max = infinity<double>;
  }
  return one;
}

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
  /// one: the map into object space is plain arithmetic, however careful the method is behind it.
  [[nodiscard]] int reach() const {
    const auto at_precision = [this](const Domain& domain) {
      return case_->precision == Precision::float32 ? domain.reach_float : domain.reach_double;
    };
    const int own = at_precision(subject_->contract.domain);
    return is_transformed(*case_) ? std::min(own, at_precision(Domain{})) : own;
  }

 private:
  const Subject* subject_;
  const Case* case_;
  std::optional<Answer> claimed_{};
  std::optional<oracle::Judgement> judgement_{};
};

}  // namespace rayproof
