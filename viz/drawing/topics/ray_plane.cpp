#include "viz/drawing/topics/ray_plane.hpp"

#include <rayproof/transform.hpp>

namespace rayproof::viz {

Shadow RayPlane::half_chord() const {
  const Shadow square = (radius - height) * (radius + height);
  return square > 0 ? Shadow(sqrt(square)) : Shadow(0);
}

RayPlane plane_of(const RayQuestion& question) {
  Ray<Shadow> ray = convert<Shadow>(question.ray);
  if (question.transform) {
    const glm::dmat4& m = *question.transform;
    const auto column = [&](int i) { return convert<Shadow>(glm::dvec3(m[i])); };
    ray = to_object(object_space<Shadow>(column(0), column(1), column(2), column(3)), ray);
  }
  const auto sphere = convert<Shadow>(std::get<Sphere<double>>(question.shape));
  const vec3<Shadow> f = ray.origin - sphere.center;
  const Shadow dd = dot(ray.direction, ray.direction);
  const Shadow t_nearest = -dot(f, ray.direction) / dd;
  const vec3<Shadow> nearest = f + t_nearest * ray.direction;
  return {sphere.radius,   sqrt(dot(nearest, nearest)),   t_nearest, sqrt(dd),
          sqrt(dot(f, f)), question.transform.has_value()};
}

}  // namespace rayproof::viz
