#pragma once
/// \file
/// Ray and sphere in the one plane that holds the ray's line and the sphere's centre: nothing of the question
/// is lost.

#include <rayproof/ray.hpp>
#include <rayproof/sphere.hpp>

#include "case/case.hpp"
#include "viz/drawing/view.hpp"
#include "viz/trace/shadow.hpp"

namespace rayproof::viz {

/// The ray runs to the right along y = 0, its point nearest the centre at x = 0; the centre lies below, at
/// (0, -height). Lengths are those of the sphere's own space, free of rounding for all that a picture can
/// show.
struct RayPlane {
  Shadow radius, height;
  Shadow t_nearest;         ///< t of the point nearest the centre
  Shadow direction_length;  ///< so that x = (t - t_nearest) · direction_length
  Shadow distance;          ///< of the origin from the centre
  bool is_transformed = false;

  [[nodiscard]] WorldPoint at(const Shadow& t) const { return {(t - t_nearest) * direction_length, 0}; }
  [[nodiscard]] WorldPoint centre() const { return {0, -height}; }
  /// The gap between line and sphere: negative where the line cuts it.
  [[nodiscard]] Shadow gap() const { return height - radius; }
  /// Half of the chord that the line cuts off; 0 where it misses.
  [[nodiscard]] Shadow half_chord() const;
};

/// The plane of a question about a sphere.
[[nodiscard]] RayPlane plane_of(const RayQuestion& question);

}  // namespace rayproof::viz
