#pragma once
/// \file
/// One subject asked one case, and what can be said of it.

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <optional>

#include "oracle/judged_answers.hpp"
#include "oracle/oracle.hpp"
#include "properties/guests/guest.hpp"
#include "properties/numbers.hpp"
#include "subjects/subject.hpp"

namespace rayproof {

/// Whether a map stands between the case's ray and its shape.
[[nodiscard]] inline bool is_transformed(const Case& one) {
  const auto* asked = std::get_if<RayQuestion>(&one.question);
  return asked != nullptr && asked->transform;
}

/// The reach of a domain at a precision.
[[nodiscard]] inline int reach_of(const Domain& domain, Precision precision) {
  return precision == Precision::float32 ? domain.reach_float : domain.reach_double;
}

/// The case asked of the whole line in place of the ray's interval.
[[nodiscard]] inline Case on_whole_line(Case one) {
  if (auto* asked = std::get_if<RayQuestion>(&one.question)) {
    asked->ray.t_min = -infinity<double>;
    asked->ray.t_max = infinity<double>;
  }
  return one;
}

/// A ray in the object's space: the world's where no transform stands between them.
[[nodiscard]] inline Ray<double> ray_in_object(const RayQuestion& asked) {
  if (!asked.transform) return asked.ray;
  Ray<double> ray = asked.ray;
  const glm::dmat3 inverse = glm::inverse(glm::dmat3(*asked.transform));
  ray.origin = inverse * (ray.origin - glm::dvec3((*asked.transform)[3]));
  ray.direction = inverse * ray.direction;
  return ray;
}

/// By how much a map magnifies errors: the condition of its 3 by 3 part in Frobenius' norm, to a few digits,
/// which a domain needs no more of.
[[nodiscard]] inline double condition_of(const glm::dmat4& map) {
  const glm::dmat3 forward(map), backward = glm::inverse(forward);
  double of_forward = 0, of_backward = 0;
  for (int i = 0; i < 3; ++i) {
    of_forward += glm::dot(forward[i], forward[i]);
    of_backward += glm::dot(backward[i], backward[i]);
  }
  return std::sqrt(of_forward) * std::sqrt(of_backward);
}

/// A guest's normal is judged no farther from a shape: a plain method's hit of a far cylinder may lie where
/// the side has any normal.
inline constexpr double far_for_details = 1024;

/// A subject and a case. The subject's answer and its judgement are computed where a property first asks for
/// them, and once only, so that properties share them.
class Trial {
 public:
  /// With what is known of answers to the case, if anything; the judgement is added to it.
  Trial(const Subject& subject, const Case& one, oracle::JudgedAnswers* known_judgements = nullptr)
      : subject_(&subject), case_(&one), known_judgements_(known_judgements) {}
  /// The case must outlive the trial.
  Trial(const Subject& subject, Case&& one, oracle::JudgedAnswers* known_judgements = nullptr) = delete;

  [[nodiscard]] const Subject& subject() const { return *subject_; }
  [[nodiscard]] const Case& question() const { return *case_; }

  /// What came of asking; of a function always an answer.
  [[nodiscard]] const Outcome& outcome() {
    if (!outcome_) outcome_ = ask(*case_);
    return *outcome_;
  }
  /// Its answer, which must be there; a guest's with what it left out filled in.
  [[nodiscard]] const Answer& claimed() {
    if (!claimed_)
      claimed_ = subject_->function != nullptr ? subject_->function(*case_)
                                               : completed(*subject_, *case_, outcome().answer);
    return *claimed_;
  }
  /// Asks the subject another case, unless its outcome is known.
  [[nodiscard]] Outcome ask(const Case& other) const {
    if (subject_->function != nullptr) return {.answer = subject_->function(other)};
    for (const auto& [one, outcome] : known_)
      if (is_same_question(*one, other)) return *outcome;
    return subject_->start()->answer(other);
  }
  /// What has come of asking the case, and other cases: nobody is asked these again.
  void know(const Outcome& own, std::vector<std::pair<const Case*, const Outcome*>> others) {
    outcome_ = own;
    known_ = std::move(others);
  }
  /// The subject's answer and its judgement are known from before: nobody is asked again.
  void recall(const Answer& answer, const oracle::Judgement& judgement) {
    claimed_ = answer;
    judgement_ = judgement;
  }
  [[nodiscard]] const oracle::Judgement& judgement() {
    if (!judgement_)
      judgement_ = !subject_->has_own_contract    ? judged(*case_, claimed())
                   : known_judgements_ == nullptr ? oracle::judge(*case_, claimed())
                                                  : known_judgements_->judge(*case_, claimed());
    return *judgement_;
  }

  [[nodiscard]] const oracle::Details& details() {
    if (!details_) details_ = oracle::judge_details(*case_, claimed());
    return *details_;
  }
  /// Whether a property has asked for them: they cost as much again, and not every case is worth that.
  [[nodiscard]] bool has_details() const { return details_.has_value(); }

  /// The error of the first hit's coordinates in the unit of the subject's promise: ε times their condition,
  /// or, of a method that promises ulps of the case as it is given, ε or ε of a coordinate beyond 1. None
  /// where the condition is endless, so that they may be anything.
  [[nodiscard]] std::optional<double> error_of_coordinates() {
    const oracle::Details& judged = details();
    const bool sees_case = !is_transformed(*case_) || subject_->takes_transforms;
    if (std::isfinite(subject_->contract.ulp.promised) && sees_case) return judged.rounded_coordinates;
    if (!judged.coordinates || std::isinf(judged.condition)) return std::nullopt;
    return *judged.coordinates == 0 ? 0 : *judged.coordinates / judged.condition;
  }

  /// Whether every length of the case lies in the domain of the subject's bounds, `spare` powers of two
  /// inside it; and every number, too, where the domain asks for that.
  [[nodiscard]] bool in_domain(int spare = 0) { return keeps_digits() && is_within(reach() - spare); }

  /// The same of the domain in which point and normal are promised: no further than the usual one, since they
  /// are plain arithmetic, however careful the method is that finds t.
  [[nodiscard]] bool in_domain_of_details() {
    return keeps_digits() && is_within(std::min(reach(), reach_of(Domain{}, case_->precision))) &&
           (subject_->has_own_contract || judgement().far <= far_for_details);
  }

  /// Whether a ray that is rounded on its way into object space has any digits left there: the first-order
  /// bounds of the contracts mean nothing where the map's condition comes near 1/ε.
  [[nodiscard]] bool keeps_digits() const {
    if (!is_transformed(*case_) || subject_->takes_transforms) return true;
    return condition_of(*std::get<RayQuestion>(case_->question).transform) <=
           std::ldexp(1.0, case_->precision == Precision::float32 ? largest_condition_float
                                                                  : largest_condition_double);
  }

  /// The numbers first: they are known without a judgement.
  [[nodiscard]] bool is_within(int limit) {
    if (!subject_->contract.domain.every_number) return lengths_within(limit);
    if (!numbers_ || numbers_->limit != limit) numbers_ = NumbersWithin{limit, all_numbers_within(limit)};
    return numbers_->are_within && lengths_within(limit);
  }
  [[nodiscard]] bool lengths_within(int limit) {
    return judgement().smallest >= -limit && judgement().largest <= limit;
  }

  /// The reach of the subject's domain at the case's precision. Under a transform, no further than the usual
  /// one: the map into object space is plain arithmetic, however careful the method is behind it.
  [[nodiscard]] int reach() const {
    if (is_transformed(*case_) && subject_->takes_transforms)
      return subject_->contract.domain.reach_transformed;
    const int own = reach_of(subject_->contract.domain, case_->precision);
    return is_transformed(*case_) ? std::min(own, reach_of(Domain{}, case_->precision)) : own;
  }

 private:
  /// Whether every number of the case that is not 0 (or an infinite end of the interval) lies within
  /// 2^±limit.
  [[nodiscard]] bool all_numbers_within(int limit) const {
    const double largest = std::ldexp(1.0, limit), smallest = std::ldexp(1.0, -limit);
    bool is_within = true;
    each_number_of(*case_, [&](double x) {
      const double size = std::abs(x);
      const bool has_size = size > 0 && std::isfinite(size);
      is_within = is_within && !(has_size && (size < smallest || size > largest));
    });
    return is_within;
  }

  /// What was last asked of the case's numbers: properties ask the same one after another.
  struct NumbersWithin {
    int limit;
    bool are_within;
  };

  const Subject* subject_;
  const Case* case_;
  oracle::JudgedAnswers* known_judgements_;
  std::optional<NumbersWithin> numbers_{};
  std::optional<Outcome> outcome_{};
  std::vector<std::pair<const Case*, const Outcome*>> known_{};
  std::optional<Answer> claimed_{};
  std::optional<oracle::Judgement> judgement_{};
  std::optional<oracle::Details> details_{};
};

}  // namespace rayproof
