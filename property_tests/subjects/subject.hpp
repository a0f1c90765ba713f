#pragma once
/// \file
/// A subject is anything that answers cases: our methods, the formulas as printed, GLM, anybody's program.

#include <algorithm>
#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <rayproof/method/contract.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "subjects/abilities.hpp"
#include "subjects/outcome.hpp"

namespace rayproof {

/// The names of the claims in listings and on command lines, in the order of `Claim`.
inline constexpr std::array<std::string_view, claim_count> claim_names{
    "verdict", "residual",    "ulp",   "rounded",      "robust",  "ascending", "moved",
    "scaled",  "reversed",    "batch", "nan",          "bounded", "contact",   "point",
    "normal",  "coordinates", "exact", "conservative", "answers"};

[[nodiscard]] constexpr std::string_view claim_name(Claim claim) {
  return claim_names.at(static_cast<std::size_t>(claim));
}

/// The same of `Standing`.
inline constexpr std::array<std::string_view, 3> standing_names{"sound", "naive", "printed"};

[[nodiscard]] constexpr std::string_view standing_name(Standing standing) {
  return standing_names.at(static_cast<std::size_t>(standing));
}

/// One method put on trial, on the cases of one topic.
struct Subject {
  std::string topic{};  ///< "sphere"
  std::string name{};   ///< "centred"
  std::string title{};  ///< one line on what it does
  Source source{};
  /// Whether it is given the transform itself, and not a ray that was rounded on its way into object space.
  bool takes_transforms = false;
  std::vector<Precision> precisions{Precision::float32, Precision::float64};
  Abilities abilities{};
  DocumentedDomain documented{};
  /// What the property tests hold it to: what it promises itself, or else what its users expect of it.
  Contract contract{};
  bool has_own_contract = true;
  /// An instance that answers cases in their own precision, for one thread. Throws std::runtime_error where
  /// there can be none.
  std::function<std::unique_ptr<Answerer>()> start{};
  /// The same as a function that never throws, whatever the bits (a NaN anywhere gives a miss), for any
  /// number of threads; null where it takes an instance. Set both by `answer_by`.
  Answer (*function)(const Case&) = nullptr;
  /// How long a program may be silent while a case waits; 0 of a function.
  std::chrono::milliseconds case_time{0};
  /// Why no more cases are to be given to it, in one sentence; empty, or null, as long as it may be asked.
  std::function<std::string()> why_given_up{};

  /// The same through the library's batch interface, the case repeated among `lanes` others; null where there
  /// is none.
  Answer (*answer_in_batch)(const Case&) = nullptr;
  /// The answers in the running-error arithmetic: each hit's t and the bound on its error; null where there
  /// is none.
  std::vector<std::pair<double, double>> (*bounded_hits)(const Case&) = nullptr;
  /// Whether the method's bounds leave the case in doubt, so that slower arithmetic decides it; null where it
  /// has none.
  bool (*is_in_doubt)(const Case&) = nullptr;
  /// Whether the method rounds nothing on the case, the ray's way into object space included; null where
  /// nobody knows.
  bool (*is_exact_on)(const Case&) = nullptr;

  [[nodiscard]] std::string full_name() const { return topic + "/" + name; }

  [[nodiscard]] bool is_given_up() const { return why_given_up && !why_given_up().empty(); }

  void answer_by(Answer (*answering)(const Case&)) {
    function = answering;
    start = [answering] { return std::make_unique<FunctionAnswerer>(answering); };
  }
  /// Answers one case, if need be by an instance started for it alone. Throws std::runtime_error where it
  /// gives no answer.
  [[nodiscard]] Answer answer(const Case& one) const {
    if (function != nullptr) return function(one);
    Outcome outcome = start()->answer(one);
    if (!outcome.is_answered()) throw std::runtime_error(full_name() + ": " + outcome.sentence);
    return outcome.answer;
  }
};

/// Every subject, in the order of the registries.
[[nodiscard]] const std::vector<Subject>& subjects();

/// The topics of the subjects: "quadratic", "sphere", …, each once.
[[nodiscard]] inline std::vector<std::string> topics() {
  std::vector<std::string> all;
  for (const Subject& subject : subjects())
    if (std::find(all.begin(), all.end(), subject.topic) == all.end()) all.push_back(subject.topic);
  return all;
}

/// The subject called "sphere/centred", or null.
[[nodiscard]] const Subject* find_subject(const std::string& full_name);

}  // namespace rayproof
