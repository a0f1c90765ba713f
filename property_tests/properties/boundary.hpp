#pragma once
/// \file
/// Cases that lie on a boundary of what is a hit, and nothing of which a plain method rounds.

#include "case/answer.hpp"
#include "case/case.hpp"
#include "subjects/boundary_places.hpp"

namespace rayproof {

/// The places that the exact answer lies on. With `is_first_alone`, only those that its first hit shows: who
/// reports no other hit has nothing to say of those.
[[nodiscard]] BoundaryPlaces boundary_places(const Case& one, bool is_first_alone = false);

/// Whether a ray runs along an axis.
[[nodiscard]] bool runs_along_axis(const Ray<double>& ray);
/// Whether the ray, in object space, comes from where the triangle's vertices turn clockwise.
[[nodiscard]] bool is_behind(const Triangle<double>& triangle, const Ray<double>& ray);
/// Whether the first hit is at the ray's origin and the second is where the ray leaves the shape again.
[[nodiscard]] bool enters_at_origin(const RayAnswer& exact);
/// Whether the ray leaves a solid at its origin, or touches it there, and meets nothing else.
[[nodiscard]] bool leaves_at_origin(const RayQuestion& asked, const RayAnswer& exact);

/// Whether some method that claims as much decides the case without a rounding.
[[nodiscard]] bool is_exact_for_some_method(const Case& one);

}  // namespace rayproof
