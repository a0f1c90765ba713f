#include <rayproof/parallelepiped/methods.hpp>

#include "viz/shapes/ray_walk.hpp"
#include "viz/shapes/topics.hpp"

namespace rayproof::viz {
namespace {

Figure parallelepiped_figure(const Sight& sight) {
  const auto solid = convert<Shadow>(std::get<Parallelepiped<double>>(sight.question.shape));
  const Place corner = sight.world.point(solid.corner);
  std::array<Place, 3> edges;
  for (std::size_t i = 0; i < 3; ++i) edges[i] = sight.world.vector(solid.edges[i]);
  Figure figure = solid_figure(corner, edges);
  figure.labels = {
      {"corner", corner}, {"e₀", corner + edges[0]}, {"e₁", corner + edges[1]}, {"e₂", corner + edges[2]}};
  return figure;
}

}  // namespace

TopicView parallelepiped_view() {
  return {parallelepiped::Topic::name, walk_ray<parallelepiped::Topic>, parallelepiped_figure};
}

}  // namespace rayproof::viz
