#include <rayproof/triangle/methods.hpp>

#include "viz/shapes/ray_walk.hpp"
#include "viz/shapes/topics.hpp"

namespace rayproof::viz {
namespace {

Figure triangle_figure(const Sight& sight) {
  const auto& triangle = std::get<Triangle<double>>(sight.question.shape);
  const Place a = sight.world.point(triangle.a);
  const Place b = sight.world.point(triangle.b);
  const Place c = sight.world.point(triangle.c);
  return flat_figure({a, b, c}, cross(b - a, c - a), {"a", "b", "c"});
}

}  // namespace

TopicView triangle_view() { return {triangle::Topic::name, walk_ray<triangle::Topic>, triangle_figure}; }

}  // namespace rayproof::viz
