// Diagnosis: that reports hits before t_min
#include "property.hpp"

#include <cmath>

bool property(const Intersect& sphere) {
  return rc::check(
      [&] {  // only that what is reported lies on the sphere, and that two are reported from outside
        const double r = *rc::gen::inRange(1, 9), k = *rc::gen::inRange(1, 9), end = *rc::gen::inRange(1, 40);
        const vec3 origin(0, 0, -10), direction(0, 0, k);
        const std::vector<double> hits = sphere(origin, direction, 0, end / k + 0.01, {0, 0, 0}, r);
        const std::size_t expected = (end > 10 - r - 0.001) + (end > 10 + r - 0.001);
        RC_ASSERT(hits.size() == expected);
        for (const double t : hits) RC_ASSERT(std::abs(length(origin + t * direction) - r) < 1e-9);
      });
}
