#include <rayproof/polygon/methods.hpp>

#include "viz/shapes/ray_walk.hpp"
#include "viz/shapes/topics.hpp"
#include "viz/trace/numbers.hpp"

namespace rayproof::viz {
namespace {

/// More names than this would hide the polygon.
constexpr std::size_t most_names = 8;

Figure polygon_figure(const Sight& sight) {
  const auto& polygon = std::get<Polygon<double>>(sight.question.shape);
  std::vector<Place> vertices;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
    vertices.push_back(sight.world.point(polygon.vertices[i]));
    if (polygon.vertices.size() <= most_names) names.push_back("v" + subscript(i));
  }
  return flat_figure(vertices, polygon::newell_normal<Shadow>(vertices, vertices.front()), names);
}

}  // namespace

TopicView polygon_view() { return {polygon::Topic::name, walk_ray<polygon::Topic>, polygon_figure}; }

}  // namespace rayproof::viz
