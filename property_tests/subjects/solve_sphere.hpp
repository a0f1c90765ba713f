#pragma once
/// \file
/// Ray/sphere cases as problems of the library, and its roots as answers.

#include <rayproof/batch/among_neighbours.hpp>
#include <rayproof/sphere/methods.hpp>
#include <rayproof/transform.hpp>

#include "subjects/solve.hpp"

namespace rayproof {

template <>
struct Reading<sphere::Topic> {
  template <class A>
  using Space = std::optional<ObjectSpace<A>>;

  /// The object's space in arithmetic A, computed from the exact matrix in A.
  template <class A>
  [[nodiscard]] static Space<A> space(const RayQuestion& question) {
    if (!question.transform) return std::nullopt;
    const auto column = [&](int i) {
      return convert<A>(convert<Plain<A>>(glm::dvec3((*question.transform)[i])));
    };
    return object_space<A>(column(0), column(1), column(2), column(3));
  }

  template <class A>
  [[nodiscard]] static sphere::Topic::Problem<A> problem(const Case& one) {
    const auto& question = std::get<RayQuestion>(one.question);
    const Space<A> object = space<A>(question);
    const Ray<A> ray = convert<A>(convert<Plain<A>>(question.ray));
    const auto shape = convert<Plain<A>>(std::get<Sphere<double>>(question.shape));
    return {object ? to_object(*object, ray) : ray, convert<A>(shape)};
  }

  template <class Method, class T>
  [[nodiscard]] static Roots<T> batch_roots(const Case& one) {
    const auto& question = std::get<RayQuestion>(one.question);
    return batch::roots_among_neighbours<Method>(
        convert<T>(question.ray), convert<T>(std::get<Sphere<double>>(question.shape)), space<T>(question));
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
