#include <rayproof/polygon/methods.hpp>

#include "viz/shapes/topics.hpp"
#include "viz/trace/numbers.hpp"

namespace rayproof::viz {
namespace {

/// More names than this would hide the polygon.
constexpr std::size_t most_names = 8;

}  // namespace

Figure figure_of(const Sight& sight, const Polygon<double>& polygon) {
  std::vector<Place> vertices;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
    vertices.push_back(sight.world.point(polygon.vertices[i]));
    if (polygon.vertices.size() <= most_names) names.push_back("v" + subscript(i));
  }
  return flat_figure(vertices, polygon::newell_normal<Shadow>(vertices, vertices.front()), names);
}

}  // namespace rayproof::viz
