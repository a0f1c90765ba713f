#pragma once
/// \file
/// The ray/plane methods, one line each.

#include <rayproof/plane/compensated.hpp>
#include <rayproof/plane/implicit.hpp>
#include <rayproof/plane/parametric.hpp>
#include <rayproof/plane/point_normal.hpp>
#include <rayproof/plane/printed_implicit.hpp>
#include <rayproof/plane/printed_parallel.hpp>
#include <rayproof/type_list.hpp>

namespace rayproof::plane {

/// The topic as the registries see it.
struct Topic {
  static constexpr const char* name = "plane";
  static constexpr double robust_bound = plane_robust_bound;
  using Methods =
      TypeList<ByEquation, ByPointAndNormal, ByParameters, Compensated, PrintedImplicit, PrintedParallel>;

  /// A ray and the plane it is put to.
  template <class T>
  struct Problem {
    Ray<T> ray;
    Plane<T> shape;

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

}  // namespace rayproof::plane
