#include <rayproof/plane/forms.hpp>
#include <rayproof/plane/methods.hpp>

#include "viz/shapes/topics.hpp"

namespace rayproof::viz {
namespace {

/// The plane in the world, as a point and a unit normal.
struct Level {
  Place point, normal;
};

Level level_of(const Sight& sight, const Plane<double>& given) {
  const auto [point, normal] = plane::as_point_normal(convert<Shadow>(given));
  const Place u = some_perpendicular(unit(normal));
  const Place v = cross(normal, u);
  return {sight.world.point(point), unit(cross(sight.world.vector(u), sight.world.vector(v)))};
}

/// The part of the plane worth drawing: around the hit, and to the foot of the ray's start.
struct Patch {
  Place middle, across, along;  ///< half its width and half its length
};

Patch patch_of(const Sight& sight, const Level& plane) {
  const Shadow from_t = isfinite(sight.ray.t_min) ? sight.ray.t_min : Shadow(0);
  const Place start = point_at(sight.ray, from_t);
  const Shadow height = dot(plane.normal, start - plane.point);
  const Place foot = start - height * plane.normal;
  const Place middle = sight.first_t ? point_at(sight.ray, *sight.first_t) : foot;
  Shadow half = std::max<Shadow>(length(middle - start) * Shadow(0.6), abs(height));
  if (half == 0) half = length(sight.ray.direction);
  const Place level_part = sight.ray.direction - dot(sight.ray.direction, plane.normal) * plane.normal;
  const bool is_steep = length(level_part) < Shadow(1e-3) * length(sight.ray.direction);
  const Place along = is_steep ? some_perpendicular(plane.normal) : unit(level_part);
  const Shadow to_foot = Shadow(1.1) * length(foot - middle);
  return {middle, half * cross(plane.normal, along), std::max(half, to_foot) * along};
}

}  // namespace

Figure figure_of(const Sight& sight, const Plane<double>& given) {
  const Level plane = level_of(sight, given);
  const Patch patch = patch_of(sight, plane);
  const auto at = [&](int across, int along) {
    return patch.middle + Shadow(across) / 2 * patch.across + Shadow(along) / 2 * patch.along;
  };
  Figure figure;
  figure.points = {at(-2, -2), at(2, -2), at(2, 2), at(-2, 2)};
  figure.faces = {{0, 1, 2, 3}};
  figure.normals = {plane.normal};
  for (int i = -1; i <= 1; ++i) {
    figure.grid.push_back({at(i, -2), at(i, 2)});
    figure.grid.push_back({at(-2, i), at(2, i)});
  }
  return figure;
}

}  // namespace rayproof::viz
