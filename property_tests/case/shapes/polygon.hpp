#pragma once
#include <rayproof/polygon.hpp>

#include "case/shape_format.hpp"

namespace rayproof {

/// Refuses what is not a polygon, in space or in the plane.
inline void validate_vertices(std::size_t count) {
  if (count < 3) throw Refusal("vertices", "the polygon's vertices must be three or more");
}

template <>
struct ShapeFormat<Polygon<double>> {
  static constexpr const char* type = "polygon";

  template <class S, class Visit>
  static void fields(S& polygon, Visit&& visit) {
    visit("vertices", polygon.vertices);
  }

  template <class Show>
  static std::string in_words(const Polygon<double>& polygon, Show&& /*has no number to show*/) {
    return "a polygon with " + std::to_string(polygon.vertices.size()) + " vertices";
  }

  static void validate(const Polygon<double>& polygon) { validate_vertices(polygon.vertices.size()); }
};

}  // namespace rayproof
