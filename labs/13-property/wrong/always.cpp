// Diagnosis: no case of yours
#include "property.hpp"

#include <cmath>

bool property(const Intersect& sphere) {
  (void)sphere;
  return true;
}
