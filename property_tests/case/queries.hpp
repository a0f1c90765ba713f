#pragma once
/// \file
/// The questions without a ray. Each is written like a shape, its `type` as the case's `query`.

#include <rayproof/quadratic.hpp>

#include "case/shapes/polygon.hpp"

namespace rayproof {

template <>
struct ShapeFormat<Quadratic<double>> {
  static constexpr const char* type = "quadratic";

  static void fields(auto& equation, auto&& visit) {
    visit("a", equation.a);
    visit("b", equation.b);
    visit("c", equation.c);
  }

  static void validate(const Quadratic<double>& /*any finite numbers will do*/) {}
};

template <>
struct ShapeFormat<PointAndPolygon<double>> : PolygonFormat {
  static constexpr const char* type = "point_in_polygon";

  static void fields(auto& asked, auto&& visit) {
    visit("point", asked.point);
    visit("vertices", asked.vertices);
  }
};

}  // namespace rayproof
