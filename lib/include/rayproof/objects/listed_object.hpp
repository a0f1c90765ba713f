#pragma once
/// \file
/// An object among others: a shape where its matrix puts it, and the record of a hit with it.

#include <optional>
#include <rayproof/normals.hpp>
#include <rayproof/topics.hpp>
#include <rayproof/transform.hpp>
#include <tuple>
#include <vector>

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

template <class Topic, class T, template <class> class Shape>
auto vectors_of(const RayTopic<Shape>* /*topic*/)
    -> std::tuple<std::vector<ListedObject<Topic, Shape<T>, T>>>;
template <class Topic, class T>
auto vectors_of(const void* /*no shape*/) -> std::tuple<>;

/// Whether a list of these vectors has one for the shape.
template <class Shape, class... Vectors>
constexpr bool holds(const std::tuple<Vectors...>* /*vectors*/) {
  return (std::is_same_v<typename Vectors::value_type::Shape, Shape> || ...);
}

/// A vector for each shape of the topics.
template <class T, class... Topics>
auto vectors_of_all(TypeList<Topics...>)
    -> decltype(std::tuple_cat(vectors_of<Topics, T>(static_cast<const Topics*>(nullptr))...));

}  // namespace objects

}  // namespace rayproof
