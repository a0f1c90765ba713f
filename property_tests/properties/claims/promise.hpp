#pragma once
/// \file
/// The bounds that a subject's contract sets for one case.

#include <algorithm>
#include <cmath>
#include <limits>

#include "properties/claims/robust_bound.hpp"
#include "properties/trial.hpp"

namespace rayproof {

/// Bounds in the units of the topic's contract (lib: sphere.hpp, quadratic.hpp).
struct Promise {
  double verdict;
  double residual;
  double ulp;
};

/// A naive method's bounds grow with the scene's size. Under a transform the ray has been rounded before the
/// method sees it: then nobody is held to more than the robust bound, and no ulp is promised.
[[nodiscard]] inline Promise promise_for(Trial& trial) {
  const Contract& contract = trial.subject().contract;
  const double growth = std::pow(trial.judgement().far, trial.subject().far_power);
  Promise promise{contract.verdict.promised * growth, contract.residual.promised * growth,
                  contract.ulp.promised};
  const auto* asked = std::get_if<RayQuestion>(&trial.question().question);
  if (asked == nullptr || !asked->transform) return promise;
  const double robust = robust_bound(trial.subject().topic).value_or(0);
  return {std::max(promise.verdict, robust), std::max(promise.residual, robust),
          std::numeric_limits<double>::infinity()};
}

}  // namespace rayproof
