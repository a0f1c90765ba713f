#include "transform.hpp"

/// All hits of the ray, ascending, with a sphere that m has taken from its own space into the world.
std::vector<HitWithNormal> transform(vec3 /*origin*/, vec3 /*direction*/, double /*t_min*/, double /*t_max*/,
                                     vec3 /*center*/, double /*radius*/, const mat4& /*m*/) {
  return {};  // your formula
}
