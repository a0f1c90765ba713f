// Diagnosis: it computes in float
#include "ray.hpp"

#include <algorithm>

double ray(vec3 origin, vec3 direction, double t_min, double t_max, vec3 point) {
  const glm::vec3 v = point - origin, d = direction;
  return std::clamp<double>(dot(v, d) / dot(d, d), t_min, t_max);
}
