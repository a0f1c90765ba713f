// Diagnosis: more digits than the function has
#include "property.hpp"

#include <cmath>

bool property(const Intersect& sphere) {
  return rc::check([&] {  // the formula again, compared without a tolerance
    const auto small = rc::gen::inRange(-99, 100);
    const vec3 f(*small, *small, *small), d(*small, *small, *small + 0.3);
    const double a = dot(d, d), b = dot(f, d), D = b * b - a * (dot(f, f) - 2500);
    if (D < 0) return;
    const std::vector<double> expected{(-b - std::sqrt(D)) / a, (-b + std::sqrt(D)) / a};
    RC_ASSERT(sphere(f, d, -INFINITY, INFINITY, {0, 0, 0}, 50) == expected);
  });
}
