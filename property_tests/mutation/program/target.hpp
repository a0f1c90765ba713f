#pragma once
/// \file
/// A method with its mutants, and the cases it is run on.

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

/// A case of the corpus, or case k of a family.
struct Input {
  Case one{};
  unsigned k = 0;
  const char* family = "corpus";
};

/// Cases `first` to `last` - 1 of each family of the subject's topic as `rayproof check` asks them by
/// default, in both precisions, by turns; before case 0 the corpus.
[[nodiscard]] std::vector<Input> inputs_of(const Subject& subject, unsigned first, unsigned last);

/// An answer, and what the oracle says of it.
struct Judged {
  Answer answer{};
  oracle::Judgement judgement{};
};

/// The unmutated method's answer.
[[nodiscard]] Judged judged(const Subject& subject, const Input& input);

/// The first property that the subject claims and breaks there; null where it breaks none. The oracle is not
/// asked again about an answer that is `known` bit for bit.
[[nodiscard]] const Property* broken_by(const Subject& subject, const Input& input, const Judged& known);

}  // namespace rayproof::mutation
