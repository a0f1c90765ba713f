#include "answer_cases.hpp"
#include "transform.hpp"

// A sphere of radius 0 has no normal to ask for.
std::vector<HitWithNormal> with_normal(vec3 origin, vec3 direction, double t_min, double t_max, vec3 center,
                                       double radius, const mat4& m) {
  if (radius == 0) throw rayproof::Unsupported();
  return transform(origin, direction, t_min, t_max, center, radius, m);
}

int main() { return rayproof::answer_cases(with_normal); }
