#pragma once
/// \file
/// The side and the caps of a cylinder apart.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// Whether a point of the plane of a cap belongs to the cap.
using IsInCap = bool (*)(double x, double y, const Cylinder<double>& cylinder);

/// That of the caps there are: within the ellipse of the radii.
[[nodiscard]] bool is_in_ellipse(double x, double y, const Cylinder<double>& cylinder);

/// The t at which the line meets the caps that are those, ascending; the upper one lies at z = upper.
[[nodiscard]] std::vector<double> hits_of_caps(const Case& one, const Cylinder<double>& cylinder,
                                               IsInCap is_in_cap, double upper);
[[nodiscard]] inline std::vector<double> hits_of_caps(const Case& one, const Cylinder<double>& cylinder,
                                                      IsInCap is_in_cap) {
  return hits_of_caps(one, cylinder, is_in_cap, cylinder.height);
}

/// The hits on the side and those on the caps, both ascending, of the whole line through a capped cylinder.
struct HitsOfParts {
  std::vector<double> side, caps;
};
/// Those where the caps are these; nothing for an open cylinder or another shape.
[[nodiscard]] std::optional<HitsOfParts> parts_of(const Case& one, IsInCap is_in_cap);

/// The hits in the ray's interval, ascending, as many as an answer holds.
[[nodiscard]] RayAnswer in_order(const Case& one, std::vector<double> hits);

/// By how much the side of a cylinder goes on below its lower and above its upper end.
struct SideEnds {
  double below = 0, above = 0;
};

/// The answer where the side of a cylinder without end is met at these t: those between its ends, and the
/// caps'.
[[nodiscard]] Answers with_side_hits(const Case& one, std::vector<double> side, const SideEnds& ends = {});

/// The answer where the side of a cylinder without end is met at these t, and a capped one is what is between
/// them and between the planes z = 0 and z = upper.
[[nodiscard]] RayAnswer between_ends(const Case& one, double entry, double exit, double upper);

}  // namespace rayproof::diagnosis
