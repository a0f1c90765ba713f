#pragma once
/// \file
/// Readings of a case that mix up the coordinates of its points and directions.

#include <glm/vec3.hpp>

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// Some of a ray question's vectors.
enum class Vectors {
  points,      ///< of the shape
  directions,  ///< of the shape: normals, edges, what spans a plane
  origin,
  direction
};

/// The case with each of these vectors changed.
[[nodiscard]] std::vector<Case> with_vectors(const Case& one, Vectors which, void (*change)(glm::dvec3&));

/// Two coordinates of each of these vectors are exchanged.
template <Vectors which, int i, int j>
[[nodiscard]] std::vector<Case> exchanged(const Case& one) {
  return with_vectors(one, which, [](glm::dvec3& v) { std::swap(v[i], v[j]); });
}
/// These vectors have the other sign.
template <Vectors which>
[[nodiscard]] std::vector<Case> negated(const Case& one) {
  return with_vectors(one, which, [](glm::dvec3& v) { v = -v; });
}
/// These vectors are read as whole numbers, cut off towards 0.
template <Vectors which>
[[nodiscard]] std::vector<Case> truncated(const Case& one) {
  return with_vectors(one, which, [](glm::dvec3& v) { v = glm::trunc(v); });
}

/// @{ Every number of the shape is read as a whole one; the ray starts at the origin of coordinates; its
/// direction is taken for a point that it goes through; x and y of the point in the plane are exchanged.
[[nodiscard]] std::vector<Case> truncated_shape(const Case& one);
[[nodiscard]] std::vector<Case> without_origin(const Case& one);
[[nodiscard]] std::vector<Case> direction_as_target(const Case& one);
[[nodiscard]] std::vector<Case> point_exchanged(const Case& one);
/// @}

}  // namespace rayproof::diagnosis
