#pragma once
/// \file
/// The ray/cylinder methods, one line each.

#include <rayproof/cylinder/centred.hpp>
#include <rayproof/cylinder/compensated.hpp>
#include <rayproof/cylinder/printed.hpp>
#include <rayproof/cylinder/textbook.hpp>
#include <rayproof/type_list.hpp>

namespace rayproof::cylinder {

/// The topic as the registries see it.
struct Topic {
  static constexpr const char* name = "cylinder";
  static constexpr double robust_bound = cylinder_robust_bound;
  using Methods = TypeList<Textbook, Centred, Compensated, Printed>;

  /// A ray and the cylinder it is put to.
  template <class T>
  struct Problem {
    Ray<T> ray;
    Cylinder<T> shape;

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

}  // namespace rayproof::cylinder
