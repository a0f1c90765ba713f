#pragma once
/// \file
/// The passes over many rays that are timed: our kernels one by one and in batch, GLM, and the floor.

#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/intersect.hpp>
#include <rayproof/batch.hpp>
#include <span>

#include "bench/contenders/contender.hpp"
#include "bench/contenders/shape_rays.hpp"
#include "bench/streaming/streaming.hpp"

namespace rayproof::report {

/// The nearest hit of each of the first `count` rays, one at a time.
template <class Method, class Rays>
void hit_one_by_one(Rays& rays, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto ray = rays.ray(i);
    rays.t[i] = nearest(ray, rays.space ? roots_in_world<Method>(*rays.space, ray, rays.shape)
                                        : Method::roots(ray, rays.shape));
    one_at_a_time();
  }
}

/// The nearest hits of the first `count` rays by the batch kernel.
template <class Method, template <class> class Shape, class T>
void hit_in_batch(ShapeRays<Shape, T>& rays, std::size_t count, InstructionSet set) {
  const auto first = [count](const std::vector<T>& column) { return std::span(column).first(count); };
  const auto& c = rays.column;
  const RayBatch<T> batch{.origin = {first(c[0]), first(c[1]), first(c[2])},
                          .direction = {first(c[3]), first(c[4]), first(c[5])},
                          .object_space = rays.space};
  nearest_hits<Method>(batch, rays.shape, std::span(rays.t).first(count), set);
}

/// GLM's answer to one ray, whose direction has length 1; of a triangle and a plane it may have any.
template <class T>
[[nodiscard]] T hit_of_glm(const Ray<T>& ray, const Sphere<T>& sphere) {
  T t{};
  const T squared = sphere.radius * sphere.radius;
  const bool hit = glm::intersectRaySphere(ray.origin, ray.direction, sphere.center, squared, t);
  return hit ? t : infinity<T>;
}
template <class T>
[[nodiscard]] T hit_of_glm(const Ray<T>& ray, const Triangle<T>& triangle) {
  glm::vec<2, T> uv{};
  T t{};
  const bool hit =
      glm::intersectRayTriangle(ray.origin, ray.direction, triangle.a, triangle.b, triangle.c, uv, t);
  return hit ? t : infinity<T>;
}

/// Whether GLM has a function for the shape.
template <template <class> class Shape, class T>
inline constexpr bool is_in_glm = requires(Ray<T> ray, Shape<T> shape) {
  hit_of_glm(ray, shape);
};

/// GLM on each ray. It asks for a unit direction: without a transform the directions were made unit vectors
/// beforehand, at no cost to GLM; with one, that can only be done after the ray has been transformed.
template <template <class> class Shape, class T>
void hit_by_glm(ShapeRays<Shape, T>& rays, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    Ray<T> ray = rays.ray(i);
    if (rays.space) {
      ray = to_object(*rays.space, ray);
      ray.direction /= glm::length(ray.direction);
    } else {
      ray.direction = {rays.unit[0][i], rays.unit[1][i], rays.unit[2][i]};
    }
    rays.t[i] = hit_of_glm(ray, rays.shape);
    one_at_a_time();
  }
}

/// The floor: reads the six numbers of each ray, writes one.
template <template <class> class Shape, class T>
void only_stream(ShapeRays<Shape, T>& rays, std::size_t count, InstructionSet set) {
  const auto& c = rays.column;
  stream(Columns<T, 6, 1>{{c[0].data(), c[1].data(), c[2].data(), c[3].data(), c[4].data(), c[5].data()},
                          {rays.t.data()},
                          count},
         set);
}

}  // namespace rayproof::report
