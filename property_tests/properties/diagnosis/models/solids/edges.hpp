#pragma once
/// \file
/// Models of faults with the edges of solids: rays through them, and edges that are rounded off; and of
/// searches along the ray that stop too soon.

#include <cmath>

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// A miss of a ray that enters a solid, and does not only touch it, through an edge, or a capped cylinder
/// through a rim, as far as rounding can say; nothing where the subject is right there, since rounding
/// decides.
[[nodiscard]] std::optional<bool> missed_through_edge(const Case& one, const Answer& got,
                                                      const Answer& exact);
/// The first hit of a solid whose edges and corners, or rims, are rounded off by up to an eighth of its
/// thickness: of a smaller one with a margin around it.
[[nodiscard]] std::optional<bool> has_rounded_edges(const Case& one, const Answer& got, const Answer& exact);
/// A hit before the surface, or beside a solid that is missed, no farther from it than `length`, in units of
/// object space.
[[nodiscard]] std::optional<bool> stops_before(const Case& one, const Answer& got, const Answer& exact,
                                               double length);
template <int power>
[[nodiscard]] std::optional<bool> stops_before(const Case& one, const Answer& got, const Answer& exact) {
  return stops_before(one, got, exact, std::pow(10.0, power));
}

}  // namespace rayproof::diagnosis
