/// \file
/// Properties about error: verdict, residual, ulp, robust, and the running-error bound.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "properties/claims/answers.hpp"
#include "properties/claims/promise.hpp"
#include "properties/claims/robust_bound.hpp"
#include "properties/property.hpp"

namespace rayproof {

namespace {

/// How a wrong verdict reads, from the side of the subject.
std::string wrong_verdict(Trial& trial) {
  const oracle::Judgement& judgement = trial.judgement();
  const char* kind = !finds_something(trial.claimed()) ? "misses what is there"
                     : judgement.hit                   ? "finds what is there, but not as often"
                                                       : "finds what is not there";
  return fmt::format("the method {}, {:.3g} contract units from a change of verdict", kind, judgement.margin);
}

/// A verdict may be wrong only within the band; a band of width 0 means never.
Ruling verdict_within(Trial& trial, double bound) {
  if (!trial.in_domain()) return Ruling::outside;
  const oracle::Judgement& judgement = trial.judgement();
  if (!judgement.wrong) return Ruling::held;
  return bound > 0 && judgement.margin <= bound ? Ruling::held : Ruling::broken;
}

Ruling residual_within(Trial& trial, double bound) {
  if (!trial.in_domain()) return Ruling::outside;
  return trial.judgement().residual <= bound ? Ruling::held : Ruling::broken;
}

Ruling verdict(Trial& trial) { return verdict_within(trial, promise_for(trial).verdict); }

Ruling residual(Trial& trial) { return residual_within(trial, promise_for(trial).residual); }

/// Where the verdict is wrong there is nothing to measure: that is the verdict's property.
Ruling ulp(Trial& trial) {
  if (!trial.in_domain() || trial.judgement().wrong) return Ruling::outside;
  const double promised = promise_for(trial).ulp;
  if (std::isinf(promised)) return Ruling::outside;
  return trial.judgement().ulp <= promised ? Ruling::held : Ruling::broken;
}

/// A shape without size (a sphere of radius 0) is no fair counterexample.
bool has_size(Trial& trial) { return std::isfinite(trial.judgement().far); }

Ruling robust_verdict(Trial& trial) {
  const std::optional<double> bound = robust_bound(trial.subject().topic);
  return bound && has_size(trial) ? verdict_within(trial, *bound) : Ruling::outside;
}

Ruling robust_residual(Trial& trial) {
  const std::optional<double> bound = robust_bound(trial.subject().topic);
  return bound && has_size(trial) ? residual_within(trial, *bound) : Ruling::outside;
}

/// `error` in units of `bound`; where the bound is 0, in units of the contract.
double excess_of(double error, double bound) { return bound > 0 ? error / bound : error; }

double verdict_excess(Trial& trial) {
  return excess_of(trial.judgement().margin, promise_for(trial).verdict);
}

double residual_excess(Trial& trial) {
  return excess_of(trial.judgement().residual, promise_for(trial).residual);
}

double ulp_excess(Trial& trial) { return excess_of(trial.judgement().ulp, promise_for(trial).ulp); }

double robust_verdict_excess(Trial& trial) {
  return excess_of(trial.judgement().margin, robust_bound(trial.subject().topic).value_or(0));
}

double robust_residual_excess(Trial& trial) {
  return excess_of(trial.judgement().residual, robust_bound(trial.subject().topic).value_or(0));
}

/// The same question to the nearest double, of the whole line: every exact root, none cut off by the
/// interval.
Case whole_line_in_double(Case one) {
  one.precision = Precision::float64;
  if (auto* asked = std::get_if<RayQuestion>(&one.question)) {
    asked->ray.t_min = -infinity<double>;
    asked->ray.t_max = infinity<double>;
  }
  return one;
}

/// The exact roots to double precision; empty where there are none (or everything is one).
std::vector<double> exact_roots(const Case& one) {
  return numbers_in(oracle::answer(whole_line_in_double(one)));
}

/// Running error analysis speaks of the roots that exist: where there are none it claims nothing.
Ruling bounded(Trial& trial) {
  if (trial.subject().bounded_hits == nullptr) return Ruling::outside;
  const auto hits = trial.subject().bounded_hits(trial.question());
  if (hits.empty()) return Ruling::outside;
  const std::vector<double> roots = exact_roots(trial.question());
  if (roots.empty()) return Ruling::outside;
  return std::all_of(hits.begin(), hits.end(),
                     [&](const std::pair<double, double>& hit) {
                       if (!std::isfinite(hit.first) || !std::isfinite(hit.second)) return true;
                       return std::any_of(roots.begin(), roots.end(), [&](double root) {
                         const double half_ulp = std::ldexp(std::abs(root), -53) + 0x1p-1074;
                         return std::abs(hit.first - root) <= hit.second + half_ulp;
                       });
                     })
             ? Ruling::held
             : Ruling::broken;
}

Evidence show_bounded(Trial& trial) {
  std::string text = "the running-error arithmetic claims";
  for (const auto& [t, bound] : trial.subject().bounded_hits(trial.question()))
    text += fmt::format(" {} ± {}", t, bound);
  return show_answer(trial, text);
}

Evidence show_verdict(Trial& trial) { return show_answer(trial, wrong_verdict(trial)); }

Evidence show_residual(Trial& trial) {
  return show_answer(trial, fmt::format("the answer misses its equation by {:.3g} contract units",
                                        trial.judgement().residual));
}

Evidence show_ulp(Trial& trial) {
  return show_answer(trial,
                     fmt::format("the answer is {:.3g} ulp from the exact one", trial.judgement().ulp));
}

}  // namespace

std::vector<Property> accuracy_properties() {
  return {
      {Claim::verdict, "verdict", "the verdict is the exact one outside the promised band", 1, verdict,
       show_verdict, verdict_excess},
      {Claim::residual, "residual", "every answer satisfies its equation to the promised residual", 1,
       residual, show_residual, residual_excess},
      {Claim::ulp, "ulp", "every answer is within the promised ulps of the exact one", 1, ulp, show_ulp,
       ulp_excess},
      {Claim::robust, "robust-verdict", "the verdict keeps the bound of the topic's best plain methods", 1,
       robust_verdict, show_verdict, robust_verdict_excess},
      {Claim::robust, "robust-residual", "the residual keeps the bound of the topic's best plain methods", 1,
       robust_residual, show_residual, robust_residual_excess},
      {Claim::bounded, "bounded", "the running-error bound encloses the exact answer", 8, bounded,
       show_bounded},
  };
}

}  // namespace rayproof
