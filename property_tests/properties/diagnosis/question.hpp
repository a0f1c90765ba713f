#pragma once
/// \file
/// What kind of question a case asks: what a cure must not change.

#include "properties/diagnosis/hypothesis.hpp"

namespace rayproof::diagnosis {

/// A case and its exact answer.
struct AnsweredCase {
  Case one{};
  Answer exact{};

  explicit AnsweredCase(Case asked);
};

/// Whether a changed case asks the same kind of thing.
[[nodiscard]] bool is_same_question(const AnsweredCase& a, const AnsweredCase& b, Keeps keeps);

/// Whether the exact answer lies on a boundary: a tangent, an edge, a vertex, a rim, an end of the interval,
/// a polygon's side, a double root.
[[nodiscard]] bool is_on_boundary(const AnsweredCase& one);

}  // namespace rayproof::diagnosis
