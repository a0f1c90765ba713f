// Diagnosis: which must be transposed
#include "transform.hpp"

std::vector<HitWithNormal> transform(vec3 origin, vec3 direction, double t_min, double t_max, vec3 center,
                                     double radius, const mat4& m) {
  const mat4 to_object = inverse(m);
  const vec3 o(to_object * vec4(origin, 1)), d(to_object * vec4(direction, 0));
  const vec3 l = o - center;
  const double a = dot(d, d), b = dot(l, d);
  const vec3 nearest = l - b / a * d;  // the line's nearest point to the centre, as in lab 6
  const double D = a * (radius * radius - dot(nearest, nearest));
  std::vector<HitWithNormal> hits;
  if (D < 0) return hits;
  for (const double t : {(-b - sqrt(D)) / a, (-b + sqrt(D)) / a}) {
    if (t < t_min || t > t_max) continue;
    const vec3 normal = (l + t * d) / radius;
    hits.push_back({t, normalize(mat3(to_object) * normal)});
  }
  return hits;
}
