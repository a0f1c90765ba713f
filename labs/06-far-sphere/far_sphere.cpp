#include "far_sphere.hpp"

/// Every t in [t_min, t_max] at which origin + t·direction lies on the sphere, ascending. The direction may
/// have any length.
std::vector<double> far_sphere(vec3 /*origin*/, vec3 /*direction*/, double /*t_min*/, double /*t_max*/,
                               vec3 /*center*/, double /*radius*/) {
  return {};  // your formula
}
