#pragma once
/// \file
/// Points in polygons as problems of the library.

#include <rayproof/point_in_polygon/methods.hpp>

#include "subjects/solve.hpp"

namespace rayproof {

template <>
struct Reading<point_in_polygon::Topic> {
  template <class A>
  [[nodiscard]] static point_in_polygon::Topic::Problem<A> problem(const Case& one) {
    return {convert<A>(std::get<PointAndPolygon<double>>(one.question))};
  }

  template <class Method, class T>
  [[nodiscard]] static Position answer(const Case& /*one*/, Position position) {
    return position;
  }
};

}  // namespace rayproof
