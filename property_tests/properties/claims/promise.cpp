#include "properties/claims/promise.hpp"

#include <algorithm>
#include <cmath>
#include <rayproof/topics.hpp>

namespace rayproof {

Promise promise_for(Trial& trial) {
  const Contract& contract = trial.subject().contract;
  const double growth = std::pow(trial.judgement().far, trial.subject().far_power);
  const Promise promise{contract.verdict.promised * growth, contract.residual.promised * growth,
                        contract.ulp.promised};
  if (!is_transformed(trial.question())) return promise;
  const double robust = robust_bound(trial.subject().topic).value_or(0);
  return {std::max(promise.verdict, robust), std::max(promise.residual, robust), infinity<double>};
}

std::optional<double> robust_bound(std::string_view topic) {
  std::optional<double> bound;
  Topics::for_each([&]<class Topic>(std::type_identity<Topic>) {
    if (topic == Topic::name) bound = Topic::robust_bound;
  });
  return bound;
}

}  // namespace rayproof
