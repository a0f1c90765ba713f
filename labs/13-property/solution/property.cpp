#include "property.hpp"

#include <cmath>

namespace {

vec3 some_point_of_sphere(vec3 center, double radius) {
  const auto component = rc::gen::inRange(-1000, 1001);
  const vec3 v(*component, *component, *component);
  RC_PRE(dot(v, v) > 0);
  return center + radius * normalize(v);
}

}  // namespace

bool property(const Intersect& sphere) {
  return rc::check("a ray through two points of a sphere meets it there and nowhere else", [&] {
    const auto small = rc::gen::inRange(-9, 10), positive = rc::gen::inRange(1, 10);
    const vec3 center(*small, *small, *small);
    const double radius = *positive / 4.0, scale = *positive / 2.0, s = *small;
    const vec3 p = some_point_of_sphere(center, radius), q = some_point_of_sphere(center, radius);
    RC_PRE(distance(p, q) > 0.1 * radius);
    // Ends of the interval at odd eighths: never at p or q, which are at multiples of 1/scale.
    const double t_min = (*small + 0.125) / scale, t_max = t_min + (*positive - 0.5) / scale;
    std::vector<double> expected;
    for (const double t : {s / scale, (s + 1) / scale})
      if (t_min <= t && t <= t_max) expected.push_back(t);
    const std::vector<double> hits = sphere(p - s * (q - p), scale * (q - p), t_min, t_max, center, radius);
    RC_ASSERT(hits.size() == expected.size());
    for (std::size_t i = 0; i < hits.size(); ++i) RC_ASSERT(std::abs(hits[i] - expected[i]) < 1e-6);
  });
}
