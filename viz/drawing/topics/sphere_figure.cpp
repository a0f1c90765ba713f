#include "viz/drawing/topics/sphere_figure.hpp"

#include <cmath>
#include <numbers>

namespace rayproof::viz {
namespace {

/// The circle of unit vectors u and v around the centre, in the world.
std::vector<Place> great_circle(const World& world, const Sphere<Shadow>& sphere, const Place& u,
                                const Place& v) {
  constexpr int sides = 72;
  std::vector<Place> points;
  for (int i = 0; i <= sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    const Place spoke = Shadow(std::cos(angle)) * u + Shadow(std::sin(angle)) * v;
    points.push_back(world.point(sphere.center + sphere.radius * spoke));
  }
  return points;
}

/// A short line on the sphere, at right angles to the ray, through its point nearest the ray's line: what the
/// line must pass by to change the verdict.
std::vector<Place> border_of(const Sight& sight, const Sphere<Shadow>& sphere) {
  const Ray<Shadow> ray = sight.world.ray_in_object_space(sight.ray);
  const Place along = unit(ray.direction);
  const Place from_centre = ray.origin - sphere.center;
  const Place offset = from_centre - dot(from_centre, along) * along;
  const Place out = length(offset) == 0 ? some_perpendicular(along) : unit(offset);
  const Place top = sphere.center + sphere.radius * out;
  const Place across = sphere.radius / 8 * cross(along, out);
  return {sight.world.point(top - across), sight.world.point(top + across)};
}

}  // namespace

Figure sphere_figure(const Sight& sight) {
  const auto sphere = convert<Shadow>(std::get<Sphere<double>>(sight.question.shape));
  const World& world = sight.world;
  const Place x{1, 0, 0};
  const Place y{0, 1, 0};
  const Place z{0, 0, 1};
  Figure figure;
  figure.ellipsoid = {world.point(sphere.center)};
  for (const Place& axis : {x, y, z})
    figure.ellipsoid.push_back(world.point(sphere.center + sphere.radius * axis));
  const std::vector<std::vector<Place>> circles{great_circle(world, sphere, x, y),
                                                great_circle(world, sphere, y, z),
                                                great_circle(world, sphere, z, x)};
  for (const auto& circle : circles) figure.extent.insert(figure.extent.end(), circle.begin(), circle.end());
  figure.borders = {border_of(sight, sphere)};
  figure.labels = {{"C", figure.ellipsoid.front()}};
  const Place centre = figure.ellipsoid.front();
  // Of a plain sphere; an ellipsoid's gradient is taken by the stage from the exact answer.
  figure.normal_at = [centre](const Place& hit) { return unit(hit - centre); };
  figure.strokes = [circles](const Place& /*toward*/) {
    std::vector<Stroke> strokes;
    for (const auto& circle : circles) strokes.push_back({circle, false, false});
    return strokes;
  };
  return figure;
}

}  // namespace rayproof::viz
