// Diagnosis: whose radius is not squared
#include "property.hpp"

#include <cmath>

bool property(const Intersect& sphere) {
  return rc::check([&] {
    const double k = *rc::gen::inRange(1, 9), start = *rc::gen::inRange(-20, 20),
                 low = *rc::gen::inRange(-20, 20);
    const double t_min = (low + 0.5) / k, t_max = t_min + *rc::gen::inRange(1, 20) / k;
    std::size_t expected = 0;
    for (const double t : {(-1 - start) / k, (1 - start) / k}) expected += t_min <= t && t <= t_max;
    RC_ASSERT(sphere({0, 0, start}, {0, 0, k}, t_min, t_max, {0, 0, 0}, 1).size() == expected);
  });
}
