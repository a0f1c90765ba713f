#pragma once
/// \file
/// What is counted while a subject answers many cases. Tallies add up in any order to the same sum.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "properties/property.hpp"

namespace rayproof {

/// How often a property was judged, and what came of it.
struct PropertyTally {
  std::uint64_t held = 0;
  std::uint64_t broken = 0;
  std::uint64_t outside = 0;

  [[nodiscard]] std::uint64_t judged() const { return held + broken; }

  void add(Ruling ruling) { ++(ruling == Ruling::held ? held : ruling == Ruling::broken ? broken : outside); }
  PropertyTally& operator+=(const PropertyTally& more) {
    held += more.held;
    broken += more.broken;
    outside += more.outside;
    return *this;
  }
};

/// The worst errors met inside the subject's domain, in the units of its contract; what stands there as
/// `measured`.
struct Worst {
  double verdict = 0;  ///< the widest margin at which a verdict was wrong
  double residual = 0;
  double ulp = 0;                                 ///< where the verdict was right
  double point = 0, normal = 0, coordinates = 0;  ///< of first hits, over `details` cases only
  std::uint64_t wrong = 0;
  std::uint64_t cases = 0;
  std::uint64_t details = 0;      ///< of the cases; those whose point, normal and coordinates were judged
  std::uint64_t transformed = 0;  ///< of the cases; another promise holds for them (promise.hpp)

  /// Takes in one trial; a case outside the domain is left out.
  void add(Trial& trial) {
    if (!trial.in_domain()) return;
    ++cases;
    if (is_transformed(trial.question())) ++transformed;
    const oracle::Judgement& judgement = trial.judgement();
    const Contract& contract = trial.subject().contract;
    const auto unit = [&](const Bound& bound) {
      return bound.far_power == 0 ? 1 : std::pow(judgement.far, bound.far_power);
    };
    residual = std::max(residual, judgement.residual / unit(contract.residual));
    if (judgement.wrong) {
      ++wrong;
      verdict = std::max(verdict, judgement.margin / unit(contract.verdict));
    } else {
      ulp = std::max(ulp, judgement.ulp);
    }
    if (trial.has_details() && trial.in_domain_of_details()) add_details(trial);
  }

  Worst& operator+=(const Worst& more) {
    verdict = std::max(verdict, more.verdict);
    residual = std::max(residual, more.residual);
    ulp = std::max(ulp, more.ulp);
    point = std::max(point, more.point);
    normal = std::max(normal, more.normal);
    coordinates = std::max(coordinates, more.coordinates);
    wrong += more.wrong;
    cases += more.cases;
    details += more.details;
    transformed += more.transformed;
    return *this;
  }

 private:
  void add_details(Trial& trial) {
    const oracle::Details& judged = trial.details();
    if (!judged.point) return;
    ++details;
    point = std::max(point, *judged.point);
    normal = std::max(normal, judged.normal.value_or(0));
    coordinates = std::max(coordinates, trial.error_of_coordinates().value_or(0));
  }
};

/// What is counted for one subject, family and precision; `properties` in the order of properties().
struct Tally {
  std::uint64_t cases = 0;
  std::uint64_t unsupported = 0;  ///< of the cases; those that are not for the subject
  std::uint64_t failures = 0;     ///< those that should have got an answer
  std::uint64_t not_asked = 0;    ///< those that were left out after too many failures
  std::uint64_t left_out = 0;     ///< beside the cases; those with numbers beyond the domain of a guest
  Worst worst{};
  std::vector<PropertyTally> properties{};

  void add(const Outcome& outcome) {
    if (outcome.kind == OutcomeKind::unsupported) ++unsupported;
    if (outcome.kind == OutcomeKind::not_asked) ++not_asked;
    if (outcome.is_failure()) ++failures;
  }

  Tally& operator+=(const Tally& more) {
    cases += more.cases;
    unsupported += more.unsupported;
    failures += more.failures;
    not_asked += more.not_asked;
    left_out += more.left_out;
    worst += more.worst;
    properties.resize(std::max(properties.size(), more.properties.size()));
    for (std::size_t p = 0; p < more.properties.size(); ++p) properties[p] += more.properties[p];
    return *this;
  }
};

}  // namespace rayproof
