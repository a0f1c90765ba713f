// Diagnosis: the interval of t is ignored
#include "sphere.hpp"

std::vector<double> sphere(vec3 origin, vec3 direction, double, double, vec3 center, double radius) {
  const vec3 l = origin - center;
  const double a = dot(direction, direction);
  const double b = dot(l, direction);
  const double c = dot(l, l) - radius * radius;
  const double D = b * b - a * c;
  std::vector<double> hits;
  if (D < 0) return hits;
  const double near = (-b - sqrt(D)) / a, far = (-b + sqrt(D)) / a;
  hits.push_back(near);
  hits.push_back(far);
  return hits;
}
