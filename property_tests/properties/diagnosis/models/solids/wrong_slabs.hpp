#pragma once
/// \file
/// Models of faults in how the origin of a ray is compared with the slabs of a solid.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// Near and far of a slab are distinguished by the sign of the origin's coordinate, not by that of the
/// direction's.
[[nodiscard]] Answers slabs_turned_by_origin(const Case& one, const Answer& exact);
/// Of a slab that the line runs along the origin is compared with the opposite sign.
[[nodiscard]] Answers slab_along_mirrored(const Case& one, const Answer& exact);
/// Of the slabs only the first that the line crosses is looked at: the loop ends there.
[[nodiscard]] Answers first_slab_alone(const Case& one, const Answer& exact);
/// A ray from beyond the solid's planes misses, whatever its direction: beyond the upper one, or the lower
/// one, of an axis, or of any. Of rays from there that head away, or miss, that is right. An answer for each
/// such mistake, always in the same order.
[[nodiscard]] Answers missed_from_beyond(const Case& one, const Answer& exact);

}  // namespace rayproof::diagnosis
