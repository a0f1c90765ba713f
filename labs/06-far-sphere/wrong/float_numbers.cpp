// Diagnosis: computes in float
#include "far_sphere.hpp"

std::vector<double> far_sphere(vec3 origin, vec3 direction, double t_min, double t_max, vec3 center,
                               double radius) {
  const vec3 l = center - origin;
  const double a = dot(direction, direction);
  const float t_nearest = dot(l, direction) / a;
  const vec3 m = l - double(t_nearest) * direction;  // from the line's nearest point to the centre
  const double D = (radius - length(m)) * (radius + length(m));
  std::vector<double> hits;
  if (D < 0) return hits;
  const float half_chord = sqrt(D / a);
  for (const float t : {t_nearest - half_chord, t_nearest + half_chord})
    if (t_min <= t && t <= t_max) hits.push_back(t);
  return hits;
}
