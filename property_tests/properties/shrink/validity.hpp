#pragma once
#include "case/case.hpp"

namespace rayproof {

/// Whether the case format accepts the case: finite numbers, a direction, an interval, a shape and a regular
/// transform.
[[nodiscard]] bool is_valid(const Case& one);

/// Whether the case's figure is a proper one of its kind: of a polygon, that neighbouring vertices differ and
/// that they enclose an area; of a triangle the same; of a box or cylinder, that it is not flat. A shrinker
/// that starts from a proper figure keeps it so.
[[nodiscard]] bool is_proper(const Case& one);

}  // namespace rayproof
