#pragma once
/// \file
/// What a shape looks like in space: the one thing that a shape brings to the wireframe pictures.

#include <functional>
#include <optional>
#include <rayproof/transform.hpp>
#include <string>
#include <utility>
#include <vector>

#include "case/case.hpp"
#include "viz/drawing/topics/camera.hpp"

namespace rayproof::viz {

/// The object-to-world map; the identity where a question has no transform.
class World {
 public:
  explicit World(const RayQuestion& question);
  [[nodiscard]] Place vector(const Place& v) const { return v.x * x_ + v.y * y_ + v.z * z_; }
  [[nodiscard]] Place point(const Place& p) const { return vector(p) + translation_; }
  [[nodiscard]] Place vector(const glm::dvec3& v) const { return vector(convert<Shadow>(v)); }
  [[nodiscard]] Place point(const glm::dvec3& p) const { return point(convert<Shadow>(p)); }
  [[nodiscard]] Ray<Shadow> ray_in_object_space(const Ray<Shadow>& ray) const {
    return to_object(object_space<Shadow>(x_, y_, z_, translation_), ray);
  }

 private:
  Place x_, y_, z_, translation_;
};

/// What a figure may need to know of the question it is drawn for.
struct Sight {
  const RayQuestion& question;
  World world;
  Ray<Shadow> ray;                ///< in the world; the ends of its interval may be infinite
  std::optional<Shadow> first_t;  ///< of the first hit, the exact one where there is one
};

/// A line of the outline.
struct Stroke {
  std::vector<Place> points;
  bool is_hidden = false;  ///< behind the figure, as it is seen
  bool is_edge = true;     ///< part of the outline, not just a help for the eye
};

/// A shape in the world.
struct Figure {
  std::vector<Place> extent{};   ///< points whose convex hull is the figure's outline as it is seen
  std::vector<Place> normals{};  ///< unit normals of the surfaces that ought not to be seen edge-on
  std::vector<Place> ring{};  ///< a polygon's vertices, filled by the even-odd rule; else the hull is filled
  std::vector<Place>
      ellipsoid{};  ///< of a round figure: its centre and the tips of three conjugate semi-axes
  std::vector<std::pair<std::string, Place>> labels{};
  /// The lines that a ray must pass by to change its verdict: edges, rims, the side's line nearest the ray.
  std::vector<std::vector<Place>> borders{};
  /// The unit normal of the surface at a hit; where left out, it is the first of `normals` everywhere.
  std::function<Place(const Place& hit)> normal_at{};
  /// The outline as it is seen from far away in the direction `toward`.
  std::function<std::vector<Stroke>(const Place& toward)> strokes{};
};

/// The hull's corners in order, anticlockwise.
[[nodiscard]] std::vector<WorldPoint> convex_hull(std::vector<WorldPoint> points);

}  // namespace rayproof::viz
