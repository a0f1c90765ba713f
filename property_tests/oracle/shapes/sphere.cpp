#include "oracle/shapes/sphere.hpp"

#include "oracle/geometry/hit.hpp"
#include "oracle/geometry/sphere_equation.hpp"

namespace rayproof::oracle {

RayAnswer answer(const RayQuestion& question, const Sphere<double>& sphere, Precision precision) {
  const ObjectRay<Ring> ray(question);
  const SphereEquation<Ring> scene(ray, sphere);
  const ExactQuadratic equation{scene.a(), scene.h(), scene.c()};
  const int discriminant = sign(equation.discriminant());
  RayAnswer result;
  if (discriminant < 0) return result;

  std::optional<ExactRoot> first;
  for (const int side : {-1, 1}) {
    if (side > 0 && discriminant == 0) break;  // a double root is one hit
    const ExactRoot root(equation, side);
    if (!is_in_interval(root, question.ray)) continue;
    if (!first) first = root;
    result.hits.push_back(round_correctly(root, precision));
  }
  if (!first) return result;

  result.contact = discriminant == 0 ? Contact::tangent : Contact::crossing;
  result.point = exact_point(question.ray, *first, precision);
  if (sphere.radius > 0) {
    const auto to_world = [&](const Vector<Ring>& v) { return ray.map ? ray.map->apply_transposed(v) : v; };
    result.normal = unit_vector(to_world(scene.from_center), to_world(scene.direction), *first, precision);
  }
  return result;
}

}  // namespace rayproof::oracle
