#include <rayproof/parallelepiped/methods.hpp>

#include "viz/shapes/topics.hpp"

namespace rayproof::viz {

Figure figure_of(const Sight& sight, const Parallelepiped<double>& given) {
  const auto solid = convert<Shadow>(given);
  const Place corner = sight.world.point(solid.corner);
  std::array<Place, 3> edges;
  for (std::size_t i = 0; i < 3; ++i) edges[i] = sight.world.vector(solid.edges[i]);
  Figure figure = solid_figure(corner, edges);
  figure.labels = {
      {"corner", corner}, {"e₀", corner + edges[0]}, {"e₁", corner + edges[1]}, {"e₂", corner + edges[2]}};
  return figure;
}

}  // namespace rayproof::viz
