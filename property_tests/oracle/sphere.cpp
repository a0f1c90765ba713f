#include "oracle/sphere.hpp"

#include <array>

#include "oracle/rounding.hpp"
#include "oracle/sphere_equation.hpp"

namespace rayproof::oracle {
namespace {

/// Whether a root lies in the ray's closed interval.
bool is_in_interval(const ExactRoot& root, const Ray<double>& ray) {
  const bool above = std::isinf(ray.t_min) || root.compare(Ring(ray.t_min)) >= 0;
  return above && (std::isinf(ray.t_max) || root.compare(Ring(ray.t_max)) <= 0);
}

/// o + d·t at the exact root t, each coordinate rounded once.
glm::dvec3 exact_point(const Ray<double>& ray, const ExactQuadratic& equation, int side,
                       Precision precision) {
  glm::dvec3 point{};
  for (int axis = 0; axis < 3; ++axis) {
    const ExactRoot coordinate =
        affine_image(equation, side, Ring(ray.origin[axis]), Ring(ray.direction[axis]));
    point[axis] = round_correctly(coordinate, precision);
  }
  return point;
}

/// The unit normal offset + t·slope (up to length) at the exact root t, each component within one ulp of 1.
glm::dvec3 exact_normal(const Vector<Ring>& offset, const Vector<Ring>& slope, const ExactQuadratic& equation,
                        int side, Precision precision) {
  const std::array<Scaled, 3> n{affine_image(equation, side, offset.x, slope.x).estimate(),
                                affine_image(equation, side, offset.y, slope.y).estimate(),
                                affine_image(equation, side, offset.z, slope.z).estimate()};
  const Scaled length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  glm::dvec3 normal{};
  for (int axis = 0; axis < 3; ++axis) {
    const long double component = (n[static_cast<std::size_t>(axis)] / length).value();
    normal[axis] = precision == Precision::float32 ? static_cast<double>(static_cast<float>(component))
                                                   : static_cast<double>(component);
  }
  return normal;
}

}  // namespace

RayAnswer answer(const RayQuestion& question, const Sphere<double>& sphere, Precision precision) {
  const ObjectRay<Ring> ray(question);
  const SphereEquation<Ring> scene(ray, sphere);
  const ExactQuadratic equation{scene.a(), scene.h(), scene.c()};
  const int discriminant = sign(equation.discriminant());
  RayAnswer result;
  if (discriminant < 0) return result;

  int first = 0;
  for (const int side : {-1, 1}) {
    if (side > 0 && discriminant == 0) break;  // a double root is one hit
    const ExactRoot root(equation, side);
    if (!is_in_interval(root, question.ray)) continue;
    if (first == 0) first = side;
    result.hits.push_back(round_correctly(root, precision));
  }
  if (first == 0) return result;

  result.contact = discriminant == 0 ? Contact::tangent : Contact::crossing;
  result.point = exact_point(question.ray, equation, first, precision);
  if (sphere.radius > 0) {
    const auto to_world = [&](const Vector<Ring>& v) { return ray.map ? ray.map->apply_transposed(v) : v; };
    result.normal =
        exact_normal(to_world(scene.from_center), to_world(scene.direction), equation, first, precision);
  }
  return result;
}

}  // namespace rayproof::oracle
