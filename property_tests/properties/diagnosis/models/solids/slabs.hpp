#pragma once
/// \file
/// Models of faults in how the three slabs of a box or a parallelepiped are put together.

#include <cmath>

#include "properties/diagnosis/models/models.hpp"
#include "properties/edges.hpp"

namespace rayproof::diagnosis {

/// The t at which the line enters and leaves each slab that it is not parallel to.
struct SlabEnds {
  std::vector<double> enters, leaves;
};
/// Those of the cube; nothing where the line runs beside a slab, if that is tested. In the slabs of the axes
/// in `turned`, each a bit, near and far are exchanged.
[[nodiscard]] std::optional<SlabEnds> slabs_of(const Cube& cube, bool tests_along = true,
                                               unsigned turned = 0);
/// The hits in the ray's interval where the line is inside from `first` to `last`.
[[nodiscard]] Answers inside_from(const Case& one, double first, double last);
/// What is found by the slabs of another cube, which the line may run along all of.
[[nodiscard]] Answers through_slabs(const Case& one, const Cube& cube);

/// @{ The line leaves at the last of the slabs' ends, or enters at the first of their beginnings: a minimum
/// and a maximum are exchanged.
[[nodiscard]] Answers leaves_at_last_end(const Case& one, const Answer& exact);
[[nodiscard]] Answers enters_at_first_beginning(const Case& one, const Answer& exact);
/// @}
/// The line is taken to enter and leave though it leaves one slab before it enters another.
[[nodiscard]] Answers leaves_before_it_enters(const Case& one, const Answer& exact);
/// @{ A line that runs along a slab is not compared with that slab; is missed, though inside; or is missed
/// where it lies in one of the slab's planes, the lower or the upper one.
[[nodiscard]] Answers slab_along_not_tested(const Case& one, const Answer& exact);
[[nodiscard]] Answers missed_along_slab(const Case& one, const Answer& exact);
[[nodiscard]] Answers missed_in_face(const Case& one, const Answer& exact, bool at_low, bool at_high);
template <bool at_low, bool at_high>
[[nodiscard]] Answers missed_in_face(const Case& one, const Answer& exact) {
  return missed_in_face(one, exact, at_low, at_high);
}
/// @}
/// A slab is divided by the direction's component along another axis. An answer for each such mistake, always
/// in the same order.
[[nodiscard]] Answers slab_divided_by_other(const Case& one, const Answer& exact);
/// Components of the direction that are smaller than this, or than this share of its length, are taken for 0.
[[nodiscard]] Answers small_components_as_zero(const Case& one, double least);
template <int power>
[[nodiscard]] Answers small_components_as_zero(const Case& one, const Answer& /*exact*/) {
  return small_components_as_zero(one, std::pow(10.0, power));
}
/// @{ In the slabs of some axes, each a bit, near and far are exchanged: always, or where the direction's
/// component is negative.
[[nodiscard]] Answers slabs_turned(const Case& one, unsigned axes, bool is_always);
template <unsigned axes>
[[nodiscard]] Answers slabs_exchanged(const Case& one, const Answer& /*exact*/) {
  return slabs_turned(one, axes, true);
}
template <unsigned axes>
[[nodiscard]] Answers slabs_unsorted(const Case& one, const Answer& /*exact*/) {
  return slabs_turned(one, axes, false);
}
/// @}
/// The t of each slab are upside down: d / (low - o).
[[nodiscard]] Answers slabs_upside_down(const Case& one, const Answer& exact);
/// The t of each slab are taken without their signs.
[[nodiscard]] Answers slabs_without_signs(const Case& one, const Answer& exact);
/// Only the three faces at a box's min, or at a parallelepiped's corner, are hit.
[[nodiscard]] Answers corner_faces_alone(const Case& one, const Answer& exact);
/// One of the six faces is missing.
[[nodiscard]] Answers face_missing(const Case& one, const Answer& exact);

}  // namespace rayproof::diagnosis
