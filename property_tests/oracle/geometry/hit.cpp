#include "oracle/geometry/hit.hpp"

namespace rayproof::oracle {

glm::dvec3 unit_vector(const std::array<Scaled, 3>& n, Precision precision) {
  const Scaled length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  glm::dvec3 unit{};
  for (int axis = 0; axis < 3; ++axis) {
    const long double component = (n[static_cast<std::size_t>(axis)] / length).value();
    unit[axis] = precision == Precision::float32 ? static_cast<double>(static_cast<float>(component))
                                                 : static_cast<double>(component);
  }
  return unit;
}

glm::dvec3 unit_vector(const Vector<Ring>& n, Precision precision) {
  return unit_vector({approximate(n.x), approximate(n.y), approximate(n.z)}, precision);
}

Vector<Ring> normal_to_world(const ObjectRay<Ring>& ray, const Vector<Ring>& normal) {
  if (!ray.map) return normal;
  const Vector<Ring> n = ray.map->apply_transposed(normal);
  return sign(ray.scale) > 0 ? n : Ring(-1.0) * n;
}

}  // namespace rayproof::oracle
