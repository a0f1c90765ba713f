#include "polygon.hpp"

/// The t in [t_min, t_max] at which the ray meets the polygon, concave or crossing itself; none where it does
/// not.
std::optional<double> polygon(vec3 /*origin*/, vec3 /*direction*/, double /*t_min*/, double /*t_max*/,
                              const std::vector<vec3>& /*vertices*/) {
  return std::nullopt;  // your formula
}
