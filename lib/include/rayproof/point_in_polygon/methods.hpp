#pragma once
/// \file
/// The point-in-polygon methods, one line each.

#include <rayproof/method/topic.hpp>
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

  template <class T>
  using Problem = PointAndPolygon<T>;

  /// Runs a method on a problem, in the problem's arithmetic.
  template <class Method, class T>
  [[nodiscard]] static Position solve(const Problem<T>& problem) {
    return Method::locate(problem);
  }
};

}  // namespace rayproof::point_in_polygon
