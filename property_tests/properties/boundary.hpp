#pragma once
/// \file
/// Cases that lie on a boundary of what is a hit, and nothing of which a plain method rounds.

#include "case/case.hpp"

namespace rayproof {

/// What decides a case that lies exactly on a boundary: a double root, the edge of a shape (or the boundary
/// of a polygon), an end of the ray's interval.
enum class BoundaryKind { none, tangent, edge, end };

[[nodiscard]] BoundaryKind boundary_in(const Case& one);

/// Whether some method that claims as much decides the case without a rounding.
[[nodiscard]] bool is_exact_for_some_method(const Case& one);

}  // namespace rayproof
