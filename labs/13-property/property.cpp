#include "property.hpp"

/// Whether the function has your property, as rapidcheck sees it.
bool property(const Intersect& sphere) {
  return rc::check([&] {
    const double t = *rc::gen::inRange(1, 100) / 8.0;
    const std::vector<double> hits = sphere({0, 0, -t - 1}, {0, 0, 1}, 0, 2 * t + 9, {0, 0, 0}, 1);
    RC_ASSERT(hits.size() <= 2U);  // true, but it says too little
  });
}
