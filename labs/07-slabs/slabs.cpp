#include "slabs.hpp"

/// Every t in [t_min, t_max] at which the ray meets the faces of the box from min to max, ascending: two, one
/// or none.
std::vector<double> slabs(vec3 /*origin*/, vec3 /*direction*/, double /*t_min*/, double /*t_max*/,
                          vec3 /*min*/, vec3 /*max*/) {
  return {};  // your formula
}
