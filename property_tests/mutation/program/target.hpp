#pragma once
/// \file
/// A method with its mutants, and the cases it is run on.

#include <string>
#include <vector>

#include "case/case.hpp"
#include "mutation/planted/state.hpp"
#include "oracle/oracle.hpp"
#include "properties/property.hpp"
#include "subjects/subject.hpp"

namespace rayproof::mutation {

/// A method of a shared object, and the state that chooses among its mutants.
struct Target {
  Subject subject;
  State& state;
};

/// A case of a file, or case k of a family.
struct Input {
  Case one{};
  unsigned k = 0;
  const char* family = "corpus";
};

/// Cases `first` to `last` - 1 of each family of the subject's topic as `rayproof check` asks them by
/// default, in both precisions, by turns.
[[nodiscard]] std::vector<Input> inputs_of(const Subject& subject, unsigned first, unsigned last);

/// An answer, and what the oracle says of it.
struct Judged {
  Answer answer{};
  oracle::Judgement judgement{};
};

/// The cases of a file that are of the subject's topic, one a line; `k` is 0, so that every property is
/// asked.
[[nodiscard]] std::vector<Input> inputs_of(const Subject& subject, const std::string& file);

/// The unmutated method's answer.
[[nodiscard]] Judged judged(const Subject& subject, const Input& input);

/// The first property that the subject claims and breaks there; null where it breaks none. The oracle is not
/// asked again about an answer that is `known` bit for bit.
[[nodiscard]] const Property* broken_by(const Subject& subject, const Input& input, const Judged& known);

}  // namespace rayproof::mutation
