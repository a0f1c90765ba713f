// Diagnosis: D = b² - 4ac where b is l·d
#include "sphere.hpp"

std::vector<double> sphere(vec3 origin, vec3 direction, double t_min, double t_max, vec3 center,
                           double radius) {
  const vec3 l = origin - center;
  const double a = dot(direction, direction);
  const double b = dot(l, direction);
  const double c = dot(l, l) - radius * radius;
  const double D = b * b - 4 * a * c;
  std::vector<double> hits;
  if (D < 0) return hits;
  const double near = (-b - sqrt(D)) / a, far = (-b + sqrt(D)) / a;
  if (t_min <= near && near <= t_max) hits.push_back(near);
  if (t_min <= far && far <= t_max) hits.push_back(far);
  return hits;
}
