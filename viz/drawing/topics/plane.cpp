#include <rayproof/plane/forms.hpp>
#include <rayproof/plane/methods.hpp>

#include "viz/drawing/topics/wireframe.hpp"

namespace rayproof::viz {
namespace {

/// The plane in the world, as a point and a unit normal.
struct Level {
  Place point, normal;
};

Level level_of(const Sight& sight) {
  const Plane<double> given = std::visit(
      []<class S>(const S& shape) -> Plane<double> {
        if constexpr (requires { Plane<double>(library_shape(shape)); })
          return library_shape(shape);
        else
          throw std::logic_error("a case was given to the wrong picture");
      },
      sight.question.shape);
  const auto [point, normal] = plane::as_point_normal(convert<Shadow>(given));
  const Place u = some_perpendicular(unit(normal));
  const Place v = cross(normal, u);
  return {sight.world.point(point), unit(cross(sight.world.vector(u), sight.world.vector(v)))};
}

/// The part of the plane worth drawing: around the hit, or under the ray's start where there is none.
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
  return {middle, half * cross(plane.normal, along), half * along};
}

/// The patch's border and a grid of four by four.
std::vector<Stroke> grid_of(const Patch& patch) {
  std::vector<Stroke> strokes;
  for (int i = -2; i <= 2; ++i) {
    const Place aside = Shadow(i) / 2 * patch.across;
    const Place ahead = Shadow(i) / 2 * patch.along;
    strokes.push_back(
        {{patch.middle + aside - patch.along, patch.middle + aside + patch.along}, false, false});
    strokes.push_back(
        {{patch.middle + ahead - patch.across, patch.middle + ahead + patch.across}, false, false});
  }
  return strokes;
}

Figure plane_figure(const Sight& sight) {
  const Level plane = level_of(sight);
  const Patch patch = patch_of(sight, plane);
  Figure figure;
  const Place near_side = patch.middle - patch.along;
  const Place far_side = patch.middle + patch.along;
  figure.extent = {near_side - patch.across, near_side + patch.across, far_side + patch.across,
                   far_side - patch.across};
  figure.normals = {plane.normal};
  figure.strokes = [patch](const Place& /*toward*/) { return grid_of(patch); };
  return figure;
}

}  // namespace

TopicView plane_view();
TopicView plane_view() { return wireframe_view<plane::Topic, plane_figure>(); }

}  // namespace rayproof::viz
