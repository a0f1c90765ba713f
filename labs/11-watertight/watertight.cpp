#include "watertight.hpp"

/// The t in [t_min, t_max] at which the ray meets the triangle; none where it does not. Of triangles that
/// share an edge, a ray at that edge meets one at least.
std::optional<double> watertight(vec3 /*origin*/, vec3 /*direction*/, double /*t_min*/, double /*t_max*/,
                                 vec3 /*a*/, vec3 /*b*/, vec3 /*c*/) {
  return std::nullopt;  // your formula
}
