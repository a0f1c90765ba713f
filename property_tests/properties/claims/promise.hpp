#pragma once
/// \file
/// The bounds that a subject's contract sets for one case.

#include <optional>
#include <string_view>

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
[[nodiscard]] Promise promise_for(Trial& trial);

/// The bound that Claim::robust speaks of: the verdict band and residual, in the topic's units with far_power
/// 0, that the best plain methods of the topic keep; nothing where the topic has no such bound.
[[nodiscard]] std::optional<double> robust_bound(std::string_view topic);

}  // namespace rayproof
