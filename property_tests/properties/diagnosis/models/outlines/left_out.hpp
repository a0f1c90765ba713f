#pragma once
/// \file
/// Models of sides and vertices of a polygon that a subject does not look at.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// Only the first `count` vertices of a polygon are looked at.
[[nodiscard]] Answers inside_of_first(const Case& one, const Answer& exact, std::size_t count);
template <std::size_t count>
[[nodiscard]] Answers first_vertices(const Case& one, const Answer& exact) {
  return inside_of_first(one, exact, count);
}

/// One side is left out, that from the vertex of this index; -2 is the last vertex but one. An answer for
/// each way of the ray whose crossings are counted, and for a vertex on its level that counts as below or
/// above.
[[nodiscard]] Answers without_side(const Case& one, const Answer& exact, int from);
template <int from>
[[nodiscard]] Answers side_missing(const Case& one, const Answer& exact) {
  return without_side(one, exact, from);
}

}  // namespace rayproof::diagnosis
