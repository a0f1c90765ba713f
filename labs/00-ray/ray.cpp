#include "ray.hpp"

/// The t in [t_min, t_max] at which the ray is nearest to the point.
double ray(vec3 /*origin*/, vec3 /*direction*/, double t_min, double /*t_max*/, vec3 /*point*/) {
  return t_min;  // your formula
}
