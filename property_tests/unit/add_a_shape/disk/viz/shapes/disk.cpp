#include <cmath>
#include <numbers>
#include <rayproof/disk/methods.hpp>

#include "viz/shapes/topics.hpp"

namespace rayproof::viz {
namespace {

/// A short line on the rim, where the ray's point in the plane is nearest to it.
Border rim_border(const Sight& sight, const Disk<Shadow>& disk, const Place& n) {
  const Ray<Shadow> ray = sight.world.ray_in_object_space(sight.ray);
  const Shadow progress = dot(n, ray.direction);
  const Shadow t = progress == 0 ? Shadow(0) : dot(n, disk.center - ray.origin) / progress;
  const Place off = point_at(ray, t) - disk.center;
  const Place in_plane = off - dot(off, n) * n;
  const Place out = length(in_plane) == 0 ? some_perpendicular(n) : unit(in_plane);
  const Place tip = disk.center + disk.radius * out;
  const Place tangent = disk.radius / 128 * cross(n, out);
  return {{sight.world.point(tip - tangent), sight.world.point(tip + tangent)},
          {unit(sight.world.vector(Shadow(-1) * out))}};
}

}  // namespace

/// The rim as a polygon with enough sides to look round.
Figure figure_of(const Sight& sight, const Disk<double>& given) {
  const auto disk = convert<Shadow>(given);
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
  Figure figure = flat_figure(rim, cross(sight.world.vector(x), sight.world.vector(y)), {});
  figure.borders = {rim_border(sight, disk, n)};
  figure.labels = {{"C", sight.world.point(disk.center)}};
  return figure;
}

}  // namespace rayproof::viz
