#include <rayproof/box/methods.hpp>

#include "viz/shapes/ray_walk.hpp"
#include "viz/shapes/topics.hpp"

namespace rayproof::viz {
namespace {

Figure box_figure(const Sight& sight) {
  const auto box = convert<Shadow>(std::get<rayproof::Box<double>>(sight.question.shape));
  const Place size = box.max - box.min;
  const World& world = sight.world;
  Figure figure = solid_figure(world.point(box.min),
                               {world.vector(Place{size.x, 0, 0}), world.vector(Place{0, size.y, 0}),
                                world.vector(Place{0, 0, size.z})});
  figure.labels = {{"min", world.point(box.min)}, {"max", world.point(box.max)}};
  return figure;
}

}  // namespace

TopicView box_view() { return {box::Topic::name, walk_ray<box::Topic>, box_figure}; }

}  // namespace rayproof::viz
