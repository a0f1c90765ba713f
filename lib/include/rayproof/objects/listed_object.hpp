#pragma once
/// \file
/// An object among others: a shape where its matrix puts it, and the record of a hit with it.

#include <optional>
#include <rayproof/normals.hpp>
#include <rayproof/topics.hpp>
#include <rayproof/transform.hpp>
#include <tuple>

namespace rayproof {

/// One hit of a ray with an object.
template <std::floating_point T>
struct HitRecord {
  T t;                ///< in lengths of the ray's direction
  std::size_t index;  ///< of the object, in the order in which they were added
  vec3<T> point;      ///< p(t)
  /// A unit vector: outward from a solid, else as normals.hpp has it; also where it points away from the
  /// ray's origin.
  vec3<T> normal;
  T u;  ///< with `v` the place in a plane or triangle, as FlatHit has them; 0 of other shapes
  T v;
};

namespace objects {

/// A shape where its matrix puts it.
template <class Topic, class S, std::floating_point T>
struct ListedObject {
  using Shape = S;
  S shape;
  std::optional<ObjectSpace<T>> space;
  std::size_t index;

  template <class Choice>
  [[nodiscard]] auto roots(const Ray<T>& ray) const {
    using Method = typename Choice::template method<Topic>;
    return space ? roots_in_world<Method>(*space, ray, shape) : Method::roots(ray, shape);
  }

  template <class Roots>
  [[nodiscard]] HitRecord<T> record(const Ray<T>& ray, const T& t, const Roots& roots) const {
    HitRecord<T> hit{t, index, point_at(ray, t), normal_in_world(space, shape, ray, t), T(0), T(0)};
    if constexpr (requires { roots.u; }) std::tie(hit.u, hit.v) = std::tie(roots.u, roots.v);
    return hit;
  }
};

}  // namespace objects

}  // namespace rayproof
