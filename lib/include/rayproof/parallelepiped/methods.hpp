#pragma once
/// \file
/// The ray/parallelepiped methods, one line each.

#include <rayproof/parallelepiped/compensated.hpp>
#include <rayproof/parallelepiped/face_planes.hpp>
#include <rayproof/parallelepiped/unit_cube.hpp>
#include <rayproof/type_list.hpp>

namespace rayproof::parallelepiped {

/// The topic as the registries see it.
struct Topic {
  static constexpr const char* name = "parallelepiped";
  static constexpr double robust_bound = parallelepiped_robust_bound;
  using Methods = TypeList<FacePlanes, UnitCube, Compensated>;

  /// A ray and the parallelepiped it is put to.
  template <class T>
  struct Problem {
    Ray<T> ray;
    Parallelepiped<T> shape;

    template <class To>
    [[nodiscard]] constexpr Problem<To> as() const {
      return {convert<To>(ray), convert<To>(shape)};
    }
  };

  /// Runs a method's kernel on a problem, in the problem's arithmetic.
  template <class Method, class T>
  [[nodiscard]] static constexpr Roots<T> solve(const Problem<T>& problem) {
    return Method::roots(problem.ray, problem.shape);
  }
};

}  // namespace rayproof::parallelepiped
