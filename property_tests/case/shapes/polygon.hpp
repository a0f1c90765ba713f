#pragma once
#include <rayproof/polygon.hpp>

#include "case/shape_format.hpp"

namespace rayproof {

/// What polygons in space and in the plane have in common.
struct PolygonFormat {
  static void validate(const auto& polygon) {
    if (polygon.vertices.size() < 3)
      throw Refusal("vertices", "the polygon's vertices must be three or more");
  }
};

template <>
struct ShapeFormat<Polygon<double>> : PolygonFormat {
  static constexpr const char* type = "polygon";

  static void fields(auto& polygon, auto&& visit) { visit("vertices", polygon.vertices); }

  static std::string in_words(const Polygon<double>& polygon, auto&& /*has no number to show*/) {
    return "a polygon with " + std::to_string(polygon.vertices.size()) + " vertices";
  }
};

/// A question without a ray is written like a shape, its `type` as the case's `query`.
template <>
struct ShapeFormat<PointAndPolygon<double>> : PolygonFormat {
  static constexpr const char* type = "point_in_polygon";

  static void fields(auto& asked, auto&& visit) {
    visit("point", asked.point);
    visit("vertices", asked.vertices);
  }
};

}  // namespace rayproof
