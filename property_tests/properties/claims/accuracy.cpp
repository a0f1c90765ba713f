/// \file
/// Properties about error: verdict, residual, ulp, robust, and the running-error bound.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "properties/claims/answers.hpp"
#include "properties/claims/promise.hpp"
#include "properties/property.hpp"
#include "subjects/default_contract.hpp"

namespace rayproof {

namespace {

/// The bound that a property holds a trial to, in contract units; nothing where it says nothing of it.
using BoundOf = std::optional<double> (*)(Trial&);

std::optional<double> promised_verdict(Trial& trial) { return promise_for(trial).verdict; }
std::optional<double> promised_residual(Trial& trial) { return promise_for(trial).residual; }
/// Where the verdict is wrong there is no ulp to measure: that is the verdict's property.
std::optional<double> promised_ulp(Trial& trial) {
  const double promised = promise_for(trial).ulp;
  return trial.judgement().wrong || std::isinf(promised) ? std::nullopt : std::optional(promised);
}
/// A shape without size (a sphere of radius 0) is no fair counterexample.
std::optional<double> robust(Trial& trial) {
  return std::isfinite(trial.judgement().far) ? robust_bound(trial.subject().topic) : std::nullopt;
}

/// A verdict may be wrong only within the band; a band of width 0 means never.
template <BoundOf bound_of>
Ruling verdict_within(Trial& trial) {
  if (!trial.in_domain()) return Ruling::outside;  // first, since it may be known without a judgement
  const std::optional<double> band = bound_of(trial);
  if (!band) return Ruling::outside;
  const oracle::Judgement& judgement = trial.judgement();
  const bool is_excused = *band > 0 && judgement.margin <= *band;
  return !judgement.wrong || is_excused ? Ruling::held : Ruling::broken;
}

template <BoundOf bound_of, double oracle::Judgement::*error>
Ruling error_within(Trial& trial) {
  if (!trial.in_domain()) return Ruling::outside;
  const std::optional<double> bound = bound_of(trial);
  if (!bound || !gives_numbers(trial.claimed())) return Ruling::outside;
  return trial.judgement().*error <= *bound ? Ruling::held : Ruling::broken;
}

/// A quarter of the format's binary digits more than the topic's best plain methods lose.
std::optional<double> far_beyond_robust(Trial& trial) {
  const std::optional<double> bound = robust(trial);
  const double digits = trial.question().precision == Precision::float32 ? 0x1p6 : 0x1p12;
  return bound ? std::optional(digits * *bound) : std::nullopt;
}

/// Of a guest: its own bound is that of the textbook, which loses with the distance what others keep.
Ruling keeps_digits(Trial& trial) {
  if (trial.subject().has_own_contract || !loses_digits_from_afar(trial.subject().topic))
    return Ruling::outside;
  const std::optional<double> bound = far_beyond_robust(trial);
  if (!bound || !trial.in_domain()) return Ruling::outside;
  const oracle::Judgement& judgement = trial.judgement();
  if (!judgement.wrong && !gives_numbers(trial.claimed())) return Ruling::outside;
  return (judgement.wrong ? judgement.margin : judgement.residual) <= *bound ? Ruling::held : Ruling::broken;
}

Evidence show_digits(Trial& trial) {
  const oracle::Judgement& judgement = trial.judgement();
  return show_answer(trial,
                     fmt::format("{:.3g} units of rounding off, where the best plain methods keep {:.3g}",
                                 judgement.wrong ? judgement.margin : judgement.residual,
                                 robust_bound(trial.subject().topic).value_or(0)));
}

/// Whether a ray's t is -0: what is rounded once is +0 there.
bool has_minus_zero(const Answer& claimed) {
  const auto* answer = std::get_if<RayAnswer>(&claimed);
  return answer != nullptr &&
         std::ranges::any_of(answer->hits.view(), [](double t) { return t == 0 && std::signbit(t); });
}

/// Bit for bit what the oracle answers; 0 and -0 are one number of a quadratic. A ray that is rounded on its
/// way into the object's space is no longer the case's.
Ruling rounded(Trial& trial) {
  if (is_transformed(trial.question()) && !trial.subject().takes_transforms) return Ruling::outside;
  if (!trial.in_domain()) return Ruling::outside;
  if (trial.subject().has_own_contract && has_minus_zero(trial.claimed())) return Ruling::broken;
  return same(trial.claimed(), oracle::answer(trial.question())) ? Ruling::held : Ruling::broken;
}

/// The error in units of its bound; where the bound is 0, in units of the contract.
template <BoundOf bound_of, double oracle::Judgement::*error>
double excess(Trial& trial) {
  const double bound = bound_of(trial).value_or(0), by = trial.judgement().*error;
  return bound > 0 ? by / bound : by;
}

/// Running error analysis speaks of the roots that exist: where there are none it claims nothing.
Ruling bounded(Trial& trial) {
  if (trial.subject().bounded_hits == nullptr) return Ruling::outside;
  const auto hits = trial.subject().bounded_hits(trial.question());
  if (hits.empty()) return Ruling::outside;
  Case one = on_whole_line(trial.question());  // where the interval cuts off no root
  one.precision = Precision::float64;
  const std::vector<double> roots = numbers_in(oracle::answer(one));
  if (roots.empty()) return Ruling::outside;
  const auto encloses_a_root = [&](const std::pair<double, double>& hit) {
    const auto& [t, error] = hit;
    if (!std::isfinite(t) || !std::isfinite(error)) return true;
    return std::ranges::any_of(roots, [&, t = t, error = error](double root) {
      const double half_ulp = std::ldexp(std::abs(root), -53) + 0x1p-1074;
      return std::abs(t - root) <= error + half_ulp;
    });
  };
  return std::ranges::all_of(hits, encloses_a_root) ? Ruling::held : Ruling::broken;
}

Evidence show_bounded(Trial& trial) {
  std::string text = "it claims";
  for (const auto& [t, bound] : trial.subject().bounded_hits(trial.question()))
    text += fmt::format(" {} ± {}", t, bound);
  return show_answer(trial, text);
}

/// The units of a judgement in words: of a program nobody has written a contract.
const char* units(const Trial& trial) {
  return trial.subject().has_own_contract ? "contract units" : "units of rounding";
}

Evidence show_verdict(Trial& trial) {
  const oracle::Judgement& judgement = trial.judgement();
  const char* const kind = !finds_something(trial.claimed()) ? "misses what is there"
                           : judgement.hit                   ? "finds what is there, but not as often"
                                                             : "finds what is not there";
  const std::string margin = std::isinf(judgement.margin) ? "and no input near it has another verdict"
                                                          : fmt::format("{:.3g} {} from a change of verdict",
                                                                        judgement.margin, units(trial));
  return show_answer(
      trial, fmt::format("{} {}, {}", trial.subject().has_own_contract ? "the method" : "it", kind, margin));
}

Evidence show_residual(Trial& trial) {
  return show_answer(trial, fmt::format("the answer misses its equation by {:.3g} {}",
                                        trial.judgement().residual, units(trial)));
}

Evidence show_ulp(Trial& trial) {
  return show_answer(trial,
                     fmt::format("the answer is {:.3g} ulp from the exact one", trial.judgement().ulp));
}

Evidence show_rounded(Trial& trial) {
  if (has_minus_zero(trial.claimed())) return show_answer(trial, "t is -0 where the exact one is 0");
  return trial.judgement().wrong ? show_verdict(trial) : show_ulp(trial);
}

}  // namespace

std::vector<Property> accuracy_properties() {
  using oracle::Judgement;
  return {
      {Claim::verdict, "verdict", "the verdict is the exact one outside the promised band", 1,
       verdict_within<promised_verdict>, show_verdict, excess<promised_verdict, &Judgement::margin>},
      {Claim::residual, "residual", "every answer satisfies its equation to the promised residual", 1,
       error_within<promised_residual, &Judgement::residual>, show_residual,
       excess<promised_residual, &Judgement::residual>},
      {Claim::residual, "digits",
       "from afar no more than a quarter of the digits are lost beyond those that the best plain methods "
       "lose",
       1, keeps_digits, show_digits, excess<far_beyond_robust, &Judgement::residual>},
      {Claim::ulp, "ulp", "every answer is within the promised ulps of the exact one", 1,
       error_within<promised_ulp, &Judgement::ulp>, show_ulp, excess<promised_ulp, &Judgement::ulp>},
      {Claim::rounded, "rounded", "the verdict is the exact one, and every t is the exact t rounded once", 1,
       rounded, show_rounded},
      {Claim::robust, "robust-verdict", "the verdict keeps the bound of the topic's best plain methods", 1,
       verdict_within<robust>, show_verdict, excess<robust, &Judgement::margin>},
      {Claim::robust, "robust-residual", "the residual keeps the bound of the topic's best plain methods", 1,
       error_within<robust, &Judgement::residual>, show_residual, excess<robust, &Judgement::residual>},
      {Claim::bounded, "bounded", "the running-error bound encloses the exact answer", 8, bounded,
       show_bounded},
  };
}

}  // namespace rayproof
