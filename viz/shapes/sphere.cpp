#include <cmath>
#include <numbers>
#include <rayproof/sphere/methods.hpp>

#include "viz/shapes/topics.hpp"

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

/// A short line on the sphere, at right angles to the ray, through its point nearest the ray's line.
Border border_of(const Sight& sight, const Sphere<Shadow>& sphere) {
  const Ray<Shadow> ray = sight.world.ray_in_object_space(sight.ray);
  const Place along = unit(ray.direction);
  const Place from_centre = ray.origin - sphere.center;
  const Place offset = from_centre - dot(from_centre, along) * along;
  // Of a ray through the centre only the rounding of these numbers is left.
  const bool is_central = length(offset) <= ldexp(length(from_centre), -200);
  const Place out = is_central ? some_perpendicular(along) : unit(offset);
  const Place top = sphere.center + sphere.radius * out;
  const Place across = sphere.radius / 8 * cross(along, out);
  return {{sight.world.point(top - across), sight.world.point(top + across)}};
}

}  // namespace

Figure figure_of(const Sight& sight, const Sphere<double>& given) {
  const auto sphere = convert<Shadow>(given);
  const World& world = sight.world;
  const std::array<Place, 3> axes{Place{1, 0, 0}, Place{0, 1, 0}, Place{0, 0, 1}};
  Figure figure;
  figure.ellipsoid = {world.point(sphere.center)};
  for (std::size_t i = 0; i < 3; ++i) {
    figure.ellipsoid.push_back(world.point(sphere.center + sphere.radius * axes[i]));
    figure.points.push_back(figure.ellipsoid.back());
    figure.points.push_back(world.point(sphere.center - sphere.radius * axes[i]));
    figure.grid.push_back(great_circle(world, sphere, axes[i], axes[(i + 1) % 3]));
  }
  figure.borders = {border_of(sight, sphere)};
  figure.labels = {{sight.question.transform ? "M·C" : "C", figure.ellipsoid.front()}};
  return figure;
}

}  // namespace rayproof::viz
