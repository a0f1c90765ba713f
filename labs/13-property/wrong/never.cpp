// Diagnosis: a right function breaks your property
#include "property.hpp"

#include <cmath>

bool property(const Intersect& sphere) {
  (void)sphere;
  return false;
}
