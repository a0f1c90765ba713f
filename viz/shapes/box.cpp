#include <rayproof/box/methods.hpp>

#include "viz/shapes/topics.hpp"

namespace rayproof::viz {

Figure figure_of(const Sight& sight, const rayproof::Box<double>& given) {
  const auto box = convert<Shadow>(given);
  const Place size = box.max - box.min;
  const World& world = sight.world;
  Figure figure = solid_figure(world.point(box.min),
                               {world.vector(Place{size.x, 0, 0}), world.vector(Place{0, size.y, 0}),
                                world.vector(Place{0, 0, size.z})});
  figure.labels = {{"min", world.point(box.min)}, {"max", world.point(box.max)}};
  return figure;
}

}  // namespace rayproof::viz
