#pragma once
/// \file
/// The bounds that a subject's contract sets for one case.

#include <algorithm>
#include <cmath>
#include <optional>
#include <rayproof/topics.hpp>
#include <string_view>

#include "properties/guests/allowance.hpp"
#include "properties/trial.hpp"
#include "subjects/default_contract.hpp"

namespace rayproof {

/// Bounds in the units of the topic's contract (lib: sphere.hpp, quadratic.hpp).
struct Promise {
  double verdict;
  double residual;
  double ulp;
};

/// The bound that Claim::robust speaks of: the verdict band and residual, in the topic's units with far_power
/// 0, that the best plain methods of the topic keep; nothing where the topic has no such bound.
[[nodiscard]] inline std::optional<double> robust_bound(std::string_view topic) {
  std::optional<double> bound;
  Topics::for_each([&]<class Topic>(std::type_identity<Topic>) {
    if (topic == Topic::name) bound = Topic::robust_bound;
  });
  return bound;
}

/// The bound in the units of the topic's contract with far_power 0, for a case of that ratio.
[[nodiscard]] inline double promised(const Bound& bound, double far) {
  return bound.far_power == 0 ? bound.promised : bound.promised * std::pow(far, bound.far_power);
}

/// The ratio by which a subject's bounds grow; for a sphere or cylinder a guest's grow no farther than to the
/// root of the rounding unit: where D = b² - ac cancels wholly, as of a sphere that is next to a point, a hit
/// may be off by the root of what D is.
[[nodiscard]] inline double growth_of(Trial& trial) {
  const double far = trial.judgement().far;
  if (trial.subject().has_own_contract || !loses_digits_from_afar(trial.subject().topic)) return far;
  return std::min(far, 1 / std::sqrt(roundoff_of(trial.question().precision)));
}

/// Under a transform the ray has been rounded before the
/// method sees it: then nobody is held to more than the robust bound, and no ulp is promised.
[[nodiscard]] inline Promise promise_for(Trial& trial) {
  const Contract& contract = trial.subject().contract;
  const double far = growth_of(trial);
  const double allowed = trial.subject().has_own_contract ? 1 : allowed_of_hits(trial.question());
  const Promise promise{allowed * promised(contract.verdict, far), allowed * promised(contract.residual, far),
                        contract.ulp.promised};
  if (!is_transformed(trial.question())) return promise;
  const double robust = robust_bound(trial.subject().topic).value_or(0);
  return {std::max(promise.verdict, robust), std::max(promise.residual, robust), infinity<double>};
}

/// How far p(t) may be from the surface: by the residual that is promised, or, where the contract promises
/// none, by the robust bound.
[[nodiscard]] inline double residual_or_robust(Trial& trial) {
  const double residual = promise_for(trial).residual;
  if (std::isfinite(trial.subject().contract.residual.promised)) return residual;
  return robust_bound(trial.subject().topic).value_or(residual);
}

/// How far the point of a hit may be from the surface: as far as p(t), and as far from p(t) as is promised. A
/// promise that grows with the ratio `far` is none for a shape without size.
[[nodiscard]] inline double promised_surface(Trial& trial) {
  return residual_or_robust(trial) + trial.subject().contract.hit.point.promised;
}

}  // namespace rayproof
