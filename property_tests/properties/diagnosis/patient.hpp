#pragma once
/// \file
/// What a diagnosis may ask: the subject, by cases alone, and a judge of its answers.

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "properties/property.hpp"

namespace rayproof {

/// A subject that breaks a property, to be asked by one thread at a time. A diagnosis knows neither its name
/// nor its steps.
struct Patient {
  /// The answers to cases, in their order; nothing where the subject gives none.
  std::function<std::vector<std::optional<Answer>>(std::span<const Case>)> ask{};
  /// The same of one case, asked of a program that has been asked nothing before; null of a function.
  std::function<std::optional<Answer>(const Case&)> ask_alone{};
  /// What the property says of an answer to a case.
  std::function<Ruling(const Case&, const Answer&)> rule{};
  /// What the property judges.
  Claim claim = Claim::verdict;
  /// It counts lost digits, which are more or fewer by luck.
  bool counts_digits = false;
};

/// A subject under one of the properties.
[[nodiscard]] Patient patient_of(const Subject& subject, const Property& property);

}  // namespace rayproof
