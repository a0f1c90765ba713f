#include "viz/drawing/topics/flat_figure.hpp"

#include <rayproof/formulas/polygon_sides.hpp>

namespace rayproof::viz {

Figure flat_figure(const std::vector<Place>& vertices, const Place& normal,
                   const std::vector<std::string>& names) {
  Figure figure;
  figure.extent = vertices;
  figure.ring = vertices;
  figure.normals = {unit(normal)};
  for (std::size_t i = 0; i < names.size(); ++i) figure.labels.emplace_back(names[i], vertices[i]);
  polygon::for_each_side(vertices, [&](const Place& a, const Place& b) { figure.borders.push_back({a, b}); });
  figure.strokes = [sides = figure.borders](const Place& /*toward*/) {
    std::vector<Stroke> strokes;
    for (const auto& side : sides) strokes.push_back({side});
    return strokes;
  };
  return figure;
}

}  // namespace rayproof::viz
