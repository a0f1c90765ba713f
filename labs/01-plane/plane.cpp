#include "plane.hpp"

/// The t in [t_min, t_max] at which origin + t·direction lies on the plane normal·p + d = 0; none where there
/// is none.
std::optional<double> plane(vec3 /*origin*/, vec3 /*direction*/, double /*t_min*/, double /*t_max*/,
                            vec3 /*normal*/, double /*d*/) {
  return std::nullopt;  // your formula
}
