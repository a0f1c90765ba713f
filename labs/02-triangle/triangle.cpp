#include "triangle.hpp"

/// (t, u, v) of the point in which the ray meets the triangle, with t in [t_min, t_max]; none where it does
/// not.
std::optional<vec3> triangle(vec3 /*origin*/, vec3 /*direction*/, double /*t_min*/, double /*t_max*/,
                             vec3 /*a*/, vec3 /*b*/, vec3 /*c*/) {
  return std::nullopt;  // your formula
}
