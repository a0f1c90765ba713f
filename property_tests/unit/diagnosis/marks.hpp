#pragma once
/// \file
/// Answers with given hits, and whether they bear the mark of a fault.

#include <initializer_list>
#include <optional>

#include "case/reader.hpp"
#include "oracle/oracle.hpp"
#include "properties/diagnosis/hypothesis.hpp"

namespace rayproof {

[[nodiscard]] inline RayAnswer with_hits(std::initializer_list<double> hits) {
  RayAnswer answer;
  for (const double t : hits) answer.hits.push_back(t);
  return answer;
}

/// Whether the answer to the case bears the mark of the model.
[[nodiscard]] inline std::optional<bool> bears(const char* model, const char* text, const Answer& got) {
  const Case one = read_case(text);
  return find_hypothesis(model)->recognise(one, got, oracle::answer(one));
}

}  // namespace rayproof
