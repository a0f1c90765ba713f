#pragma once
/// \file
/// What a run of the property tests is to do.

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "generators/generators.hpp"
#include "properties/guests/probe.hpp"
#include "properties/property.hpp"

namespace rayproof {

/// Which subjects, families, properties and precisions; how many cases, from which seed. An empty list means
/// all.
struct Settings {
  std::uint64_t seed = 2022;
  std::uint64_t cases = 10'000;                         ///< for each subject, family and precision
  std::optional<std::chrono::duration<double>> time{};  ///< stop starting new rounds after this
  int jobs = 0;                                         ///< threads; 0 for as many as the machine has
  std::vector<std::string> shapes{};
  std::vector<std::string> methods{};     ///< "centred" or "sphere/centred"
  std::vector<std::string> properties{};  ///< a property's name, or its claim's
  std::vector<std::string> families{};
  std::vector<Precision> precisions{};
  bool count_labels = true;  ///< label a sample of each family
  bool measure_all = false;  ///< measure errors that no property asks for, too
};

/// The settings in terms of the registries.
struct Plan {
  Settings settings{};
  std::vector<const Subject*> subjects{};
  std::vector<const Family*> families{};
  std::vector<bool> is_wanted{};  ///< for each of properties()
  std::vector<Precision> precisions{};
  std::vector<Failure> failures{};  ///< what the guests failed at before the run
};

/// A name that no registry knows: one sentence that says which names there are.
class UnknownName : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The plan for the subjects of the registry, or for others, which must outlive it. Throws UnknownName, also
/// where the filters together leave nothing to do.
[[nodiscard]] Plan make_plan(const Settings& settings, const std::vector<Subject>& all_subjects = subjects());

/// Whether the subject holds itself to the property.
[[nodiscard]] bool claims(const Subject& subject, const Property& property);

/// Throws UnknownName where a property or a method that the settings name would be judged by nothing, since
/// the contracts say nothing of it.
void expect_claimed(const Plan& plan);

/// What its contract says of how the subject breaks the property; null where it says nothing.
[[nodiscard]] const Refutation* declared_refutation(const Subject& subject, const Property& property);
[[nodiscard]] inline bool is_declared_refuted(const Subject& subject, const Property& property) {
  return declared_refutation(subject, property) != nullptr;
}

}  // namespace rayproof
