#pragma once
/// \file
/// What the topics of all shapes have in common: a problem is a ray and a shape, and a method finds its
/// roots.

#include <rayproof/ray.hpp>

namespace rayproof {

/// The base of a shape's topic, as the registries see it.
template <template <class> class Shape>
struct RayTopic {
  /// A ray and the shape it is tested against.
  template <class T>
  struct Problem {
    Ray<T> ray;
    Shape<T> shape;

    template <class To>
    [[nodiscard]] constexpr Problem<To> as() const {
      return {convert<To>(ray), convert<To>(shape)};
    }
  };

  /// Runs a method's kernel on a problem, in the problem's arithmetic.
  template <class Method, class T>
  [[nodiscard]] static constexpr auto solve(const Problem<T>& problem) {
    return Method::roots(problem.ray, problem.shape);
  }
};

}  // namespace rayproof
