#pragma once
/// \file
/// The ray/polygon methods, one line each.

#include <rayproof/polygon/compensated.hpp>
#include <rayproof/polygon/parity.hpp>
#include <rayproof/polygon/printed_parity.hpp>
#include <rayproof/polygon/winding.hpp>
#include <rayproof/type_list.hpp>

namespace rayproof::polygon {

/// The topic as the registries see it.
struct Topic {
  static constexpr const char* name = "polygon";
  static constexpr double robust_bound = polygon_robust_bound;
  using Methods = TypeList<Parity, Winding, Compensated, PrintedParity>;

  /// A ray and the polygon it is put to.
  template <class T>
  struct Problem {
    Ray<T> ray;
    Polygon<T> shape;

    template <class To>
    [[nodiscard]] Problem<To> as() const {
      return {convert<To>(ray), convert<To>(shape)};
    }
  };

  /// Runs a method's kernel on a problem, in the problem's arithmetic.
  template <class Method, class T>
  [[nodiscard]] static auto solve(const Problem<T>& problem) {
    return Method::roots(problem.ray, problem.shape);
  }
};

}  // namespace rayproof::polygon
