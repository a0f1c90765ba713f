#include <rayproof/disk/methods.hpp>

#include <cmath>
#include <numbers>

#include "viz/drawing/topics/flat_figure.hpp"
#include "viz/drawing/topics/wireframe.hpp"

namespace rayproof::viz {
namespace {

/// The rim as a polygon with enough sides to look round.
Figure disk_figure(const Sight& sight) {
  const auto disk = convert<Shadow>(std::get<Disk<double>>(sight.question.shape));
  const Place n = unit(disk.normal);
  const Place x = some_perpendicular(n);
  const Place y = cross(n, x);
  constexpr int sides = 120;
  std::vector<Place> rim;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    const Place spoke = Shadow(std::cos(angle)) * x + Shadow(std::sin(angle)) * y;
    rim.push_back(sight.world.point(disk.center + disk.radius * spoke));
  }
  const Place across = cross(sight.world.vector(x), sight.world.vector(y));
  Figure figure = flat_figure(rim, across, {});
  figure.labels = {{"C", sight.world.point(disk.center)}};
  return figure;
}

}  // namespace

TopicView disk_view();
TopicView disk_view() { return wireframe_view<disk::Topic, disk_figure>(); }

}  // namespace rayproof::viz
