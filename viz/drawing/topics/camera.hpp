#pragma once
/// \file
/// Looking at a ray and a figure in space, without perspective: parallel lines stay parallel, and lengths
/// across the line of sight are true.

#include <rayproof/vec3.hpp>
#include <vector>

#include "viz/drawing/view.hpp"

namespace rayproof::viz {

/// A point or vector of the world.
using Place = vec3<Shadow>;

[[nodiscard]] glm::dvec3 rounded(const Place& v);
[[nodiscard]] Shadow length(const Place& v);
/// Of length 1; 0 stays 0.
[[nodiscard]] Place unit(const Place& v);
/// A unit vector at right angles to a unit vector.
[[nodiscard]] Place some_perpendicular(const Place& v);

/// An orthonormal frame whose `right` follows the ray as it is seen, so that the ray runs along y = 0 of the
/// picture. `toward` points from the scene to the eye.
struct ViewCamera {
  Place origin;  ///< a point of the ray's line; (0, 0) of the picture
  Place right, up, toward;

  [[nodiscard]] WorldPoint see(const Place& p) const {
    const Place from_origin = p - origin;
    return {dot(from_origin, right), dot(from_origin, up)};
  }
  [[nodiscard]] std::vector<WorldPoint> see(const std::vector<Place>& points) const;

  /// From the side on which `toward` lies, which must not be along the ray; unit vectors.
  [[nodiscard]] static ViewCamera from(const Place& origin, const Place& toward, const Place& along_ray);

  /// From where neither the ray is seen end-on nor a surface with one of the given unit normals edge-on.
  [[nodiscard]] static ViewCamera chosen(const Place& origin, const Place& along_ray,
                                         const std::vector<Place>& normals);
};

}  // namespace rayproof::viz
