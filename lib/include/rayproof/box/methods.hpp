#pragma once
/// \file
/// The ray/box methods, one line each.

#include <rayproof/box/compensated.hpp>
#include <rayproof/box/padded.hpp>
#include <rayproof/box/printed_slabs.hpp>
#include <rayproof/box/slabs.hpp>
#include <rayproof/box/slabs_inverse.hpp>
#include <rayproof/type_list.hpp>

namespace rayproof::box {

/// The topic as the registries see it.
struct Topic {
  static constexpr const char* name = "box";
  static constexpr double robust_bound = box_robust_bound;
  using Methods = TypeList<Slabs, SlabsInverse, Padded, Compensated, PrintedSlabs>;

  /// A ray and the box it is put to.
  template <class T>
  struct Problem {
    Ray<T> ray;
    Box<T> shape;

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

}  // namespace rayproof::box
