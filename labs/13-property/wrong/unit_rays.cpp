// Diagnosis: takes the direction for a unit vector
#include "property.hpp"

#include <cmath>

bool property(const Intersect& sphere) {
  return rc::check([&] {  // through the centre, always with |d| = 1
    const double r = *rc::gen::inRange(2, 9), start = *rc::gen::inRange(-20, 20),
                 low = *rc::gen::inRange(-20, 20);
    const double t_min = low + 0.5, t_max = t_min + *rc::gen::inRange(1, 20);
    std::vector<double> expected;
    for (const double t : {-r - start, r - start})
      if (t_min <= t && t <= t_max) expected.push_back(t);
    RC_ASSERT(sphere({0, 0, start}, {0, 0, 1}, t_min, t_max, {0, 0, 0}, r) == expected);
  });
}
