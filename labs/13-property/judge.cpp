#include "answer_questions.hpp"
#include "property.hpp"

namespace {

enum class SphereFault { none, other_formula, radius, unit_direction, behind, no_end, smaller_root };

/// A sphere with one fault, or with none.
std::vector<double> sphere(SphereFault fault, vec3 origin, vec3 direction, double t_min, double t_max,
                           vec3 center, double radius) {
  const vec3 f = origin - center;
  const double a = fault == SphereFault::unit_direction ? 1 : dot(direction, direction);
  const double b = dot(f, direction), r2 = fault == SphereFault::radius ? radius : radius * radius;
  double D = b * b - a * (dot(f, f) - r2);
  if (fault == SphereFault::other_formula) {  // the same, by the ray's nearest point
    const vec3 nearest = f - b / a * direction;
    D = a * (r2 - dot(nearest, nearest));
  }
  if (!(D >= 0)) return {};
  std::vector<double> roots{(-b - std::sqrt(D)) / a};
  if (fault != SphereFault::smaller_root) roots.push_back((-b + std::sqrt(D)) / a);
  if (fault == SphereFault::behind) t_min = -INFINITY;
  if (fault == SphereFault::no_end) t_max = INFINITY;
  std::erase_if(roots, [&](double t) { return t < t_min || t > t_max; });
  return roots;
}

}  // namespace

int main() {
  setenv("RC_PARAMS", "seed=2026", 0);  // the same cases each time
  return rayproof::answer_questions([](int fault) {
    return property(
        [fault](auto... arguments) { return sphere(static_cast<SphereFault>(fault), arguments...); });
  });
}
