#pragma once
/// \file
/// Models of faults with the edges of solids: rays through them, boxes whose edges are rounded off, and boxes
/// whose faces are rounded.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// A miss of a ray that enters a solid, and does not only touch it, through an edge, or a capped cylinder
/// through a rim, as far as rounding can say; nothing where the subject is right there, since rounding
/// decides.
[[nodiscard]] std::optional<bool> missed_through_edge(const Case& one, const Answer& got,
                                                      const Answer& exact);
/// The first hit of a box whose edges and corners are rounded off by up to an eighth of its smallest side: of
/// a smaller box with a margin around it.
[[nodiscard]] std::optional<bool> has_rounded_edges(const Case& one, const Answer& got, const Answer& exact);
/// The answer of the box that a rounded centre and rounded half lengths make, or min and a rounded size.
[[nodiscard]] std::optional<bool> is_of_rounded_centre(const Case& one, const Answer& got,
                                                       const Answer& exact);

}  // namespace rayproof::diagnosis
