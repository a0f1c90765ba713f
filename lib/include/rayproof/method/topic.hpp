#pragma once
/// \file
/// What a topic is made of: the list of its methods, and of a shape's topic its problem, a ray and the shape.

#include <cstddef>
#include <rayproof/ray.hpp>
#include <type_traits>

namespace rayproof {

/// A list of types, and running something once for each of them.
template <class... Types>
struct TypeList {
  static constexpr std::size_t size = sizeof...(Types);

  /// Calls `visit(std::type_identity<T>{})` for each type of the list, in order.
  template <class Visit>
  static constexpr void for_each(Visit&& visit) {
    (visit(std::type_identity<Types>{}), ...);
  }
};

/// A ray and the shape it is tested against.
template <template <class> class Shape, class T>
struct RayProblem {
  Ray<T> ray;
  Shape<T> shape;
};

/// The same problem in another arithmetic.
template <class To, template <class> class Shape, class From>
[[nodiscard]] constexpr RayProblem<Shape, To> convert(const RayProblem<Shape, From>& problem) {
  return {convert<To>(problem.ray), convert<To>(problem.shape)};
}

/// The base of a shape's topic, as the registries see it. The topic names two of its methods for who does not
/// want to choose: `Plain`, a quick one for pictures (sound, but of the parallelepiped), and `Exact`, whose
/// verdict is the exact one and whose t is the exact one rounded once.
template <template <class> class Shape>
struct RayTopic {
  template <class T>
  using Problem = RayProblem<Shape, T>;

  /// Runs a method's kernel on a problem, in the problem's arithmetic.
  template <class Method, class T>
  [[nodiscard]] static constexpr auto solve(const Problem<T>& problem) {
    return Method::roots(problem.ray, problem.shape);
  }
};

}  // namespace rayproof
