#pragma once
/// \file
/// The point-in-polygon methods, one line each.

#include <rayproof/method/type_list.hpp>
#include <rayproof/point_in_polygon/compensated.hpp>
#include <rayproof/point_in_polygon/parity.hpp>
#include <rayproof/point_in_polygon/printed_parity.hpp>
#include <rayproof/point_in_polygon/winding.hpp>

namespace rayproof::point_in_polygon {

/// The topic as the registries see it.
struct Topic {
  static constexpr const char* name = "point_in_polygon";
  static constexpr double robust_bound = point_in_polygon_robust_bound;
  using Methods = TypeList<Parity, Winding, Compensated, PrintedParity>;

  /// The point and the polygon.
  template <class T>
  struct Problem {
    PointAndPolygon<T> question;

    template <class To>
    [[nodiscard]] Problem<To> as() const {
      return {convert<To>(question)};
    }
  };

  /// Runs a method on a problem.
  template <class Method, class T>
  [[nodiscard]] static auto solve(const Problem<T>& problem) {
    return Method::locate(problem.question);
  }
};

}  // namespace rayproof::point_in_polygon
