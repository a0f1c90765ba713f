#include "cylinder.hpp"

/// Every t in [t_min, t_max] at which the ray meets the cylinder (x/rx)² + (y/ry)² = 1 between z = 0 and z =
/// height, ascending; with both caps where it is capped.
std::vector<double> cylinder(vec3 /*origin*/, vec3 /*direction*/, double /*t_min*/, double /*t_max*/,
                             double /*rx*/, double /*ry*/, double /*height*/, bool /*capped*/) {
  return {};  // your formula
}
