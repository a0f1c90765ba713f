/// \file
/// Where what is small, or large, begins.

#include <cmath>
#include <numeric>

#include "properties/claims/similarity.hpp"
#include "properties/diagnosis/examination/examination.hpp"
#include "properties/engine/consultation.hpp"

namespace rayproof::diagnosis {

/// Models of what is small, or large, differ in where that begins. The simplest case is made larger, or
/// smaller, step by step, until it is right: where the model of the group does not explain all that is wrong,
/// or foresees what is right to be wrong, the one is taken that does so least.
Diagnosis Consultation::of_its_size(const Diagnosis& group, const Case& simplest) const {
  const auto is_of_size = [](const Hypothesis& one) {
    return one.predict != nullptr && (one.of_sizes == OfSizes::small || one.of_sizes == OfSizes::limit);
  };
  if (group.cause == nullptr || !is_of_size(*group.cause) || finding_.is_declared ||
      finding_.subject->has_own_contract)
    return group;
  std::vector<Case> steps{simplest}, failing, passing = complaint_.passing;
  for (int k = 1; k <= 20; ++k)
    steps.push_back(
        scaled_twin(simplest, std::ldexp(1.0, group.cause->of_sizes == OfSizes::small ? k : -k), 1).one);
  const std::vector<std::optional<Answer>> answers = complaint_.patient.ask(steps);
  for (std::size_t k = 0; k < steps.size(); ++k)
    if (answers[k])
      (complaint_.patient.rule(steps[k], *answers[k]) == Ruling::broken ? failing : passing)
          .push_back(steps[k]);
  for (const std::size_t i : group.cases) failing.push_back(complaint_.failing[i]);
  const Examination examination(complaint_.patient, failing, passing);
  std::vector<std::size_t> all(failing.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const auto misfit = [&](const Hypothesis& one) {
    const std::vector<std::size_t> explained = examination.explained(one, all);
    return all.size() - explained.size() + examination.contradictions(one, explained);
  };
  Diagnosis fitted = group;
  std::size_t least = misfit(*group.cause);
  for (const Hypothesis& one : hypotheses()) {
    if (least == 0) break;
    if (!is_of_size(one) || one.of_sizes != group.cause->of_sizes) continue;
    const std::size_t own = misfit(one);
    if (own >= least) continue;
    least = own;
    fitted.cause = &one;
    fitted.sentence = one.sentence;
  }
  return fitted;
}

}  // namespace rayproof::diagnosis
