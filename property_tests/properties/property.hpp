#pragma once
/// \file
/// Properties: what must hold of every subject that claims it, whatever the case.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "properties/trial.hpp"

namespace rayproof {

/// What a property says of a trial: it holds, it is broken, or the case lies outside what it speaks of.
enum class Ruling { held, broken, outside };

/// What a finding shows of a trial that broke a property.
struct Evidence {
  Answer got{};
  Answer exact{};
  std::optional<double> error_ulp{};  ///< nothing where the verdict is wrong
  std::string note{};                 ///< one sentence: what was found
  /// Why there is no `got`: the subject gave no answer.
  std::string no_answer{};
  /// The other case that `got` and `exact` answer, where that is not the trial's.
  std::optional<Case> other{};
};

/// One property. Two properties may serve one claim: a robust method keeps its verdict *and* its residual.
struct Property {
  Claim claim{};
  std::string_view name{};       ///< "robust-verdict"
  std::string_view statement{};  ///< what is claimed, in plain words
  /// Tested on one case in this many: expensive properties need not see them all.
  unsigned every = 1;
  Ruling (*rule)(Trial&) = nullptr;
  Evidence (*show)(Trial&) = nullptr;
  /// How badly a broken trial breaks it: its error in units of the bound; null where there is only yes and
  /// no.
  double (*excess)(Trial&) = nullptr;
  /// The other cases that it asks the subject, so that they can be asked together with the trial's.
  std::vector<Case> (*asks)(const Case&) = nullptr;
};

/// What a property says of a trial that may have no answer: where it has none, only `answers` speaks.
[[nodiscard]] Ruling ruling_of(const Property& property, Trial& trial);

/// On one case in how many a property is tested: a guest is asked other cases more rarely, since those cost
/// it as much as any.
[[nodiscard]] unsigned spacing(const Subject& subject, const Property& property);

/// Every property, in the order of the claims.
[[nodiscard]] const std::vector<Property>& properties();

/// The property of that name, or null.
[[nodiscard]] const Property* find_property(std::string_view name);

/// The properties by theme; each is a line of properties.cpp.
[[nodiscard]] std::vector<Property> accuracy_properties();
[[nodiscard]] std::vector<Property> symmetry_properties();
[[nodiscard]] std::vector<Property> safety_properties();
[[nodiscard]] std::vector<Property> details_properties();
[[nodiscard]] std::vector<Property> doubt_properties();
[[nodiscard]] std::vector<Property> exact_properties();
[[nodiscard]] std::vector<Property> protocol_properties();

/// The subject's own answer beside the exact one.
[[nodiscard]] Evidence show_answer(Trial& trial, std::string note);

/// `got` beside the exact answer of `one`, of which it is claimed.
[[nodiscard]] Evidence show_answer(const Case& one, const Answer& got, std::string note);

}  // namespace rayproof
