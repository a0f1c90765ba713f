#pragma once
/// \file
/// Ray/sphere cases as problems of the library, and its roots as answers.

#include <rayproof/sphere/methods.hpp>
#include <rayproof/transform.hpp>

#include "subjects/solve.hpp"

namespace rayproof {

template <>
struct Reading<sphere::Topic> {
  template <class T>
  using Space = std::optional<ObjectSpace<T>>;

  template <class T>
  [[nodiscard]] static Space<T> space(const RayQuestion& question) {
    if (!question.transform) return std::nullopt;
    return object_space(glm::mat<4, 4, T>(*question.transform));
  }

  template <class T>
  [[nodiscard]] static sphere::Topic::Problem<T> problem(const Case& one) {
    const auto& question = std::get<RayQuestion>(one.question);
    const Space<T> object = space<T>(question);
    const Ray<T> ray = convert<T>(question.ray);
    return {object ? to_object(*object, ray) : ray, convert<T>(std::get<Sphere<double>>(question.shape))};
  }

  /// The hits in the ray's interval; point and normal in the world, for the first of them.
  template <class T>
  [[nodiscard]] static RayAnswer answer(const Case& one, const Roots<T>& roots) {
    const auto& question = std::get<RayQuestion>(one.question);
    const Ray<T> ray = convert<T>(question.ray);
    RayAnswer result;
    const bool is_double = roots.discriminant == 0;
    if (in_interval(ray, roots.lo)) result.hits.push_back(static_cast<double>(roots.lo));
    if (!is_double && in_interval(ray, roots.hi)) result.hits.push_back(static_cast<double>(roots.hi));
    if (result.hits.count == 0) return result;

    const auto t = static_cast<T>(result.hits.t[0]);
    result.contact = is_double ? Contact::tangent : Contact::crossing;
    result.point = glm::dvec3(point_at(ray, t));
    const auto [object_ray, shape] = problem<T>(one);
    if (shape.radius == 0) return result;
    const vec3<T> normal = normal_at(shape, point_at(object_ray, t));
    const Space<T> object = space<T>(question);
    result.normal = glm::dvec3(object ? normal_to_world(*object, normal) : normal);
    return result;
  }
};

}  // namespace rayproof
