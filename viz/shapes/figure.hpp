#pragma once
/// \file
/// What a shape looks like in space, the one thing that a shape brings to the pictures; and a ray beside it:
/// from which side they are seen, and where the ray passes nearest to the outline.

#include <array>
#include <optional>
#include <rayproof/transform.hpp>
#include <rayproof/vec3.hpp>
#include <string>
#include <utility>
#include <vector>

#include "case/answer.hpp"
#include "case/case.hpp"
#include "viz/scene/stage.hpp"
#include "viz/trace/numbers.hpp"

namespace rayproof::viz {

/// A point or vector of the world, without rounding for all that a picture can show.
using Place = vec3<Shadow>;

[[nodiscard]] inline glm::dvec3 rounded(const Place& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}
[[nodiscard]] inline std::vector<glm::dvec3> rounded(const std::vector<Place>& places) {
  std::vector<glm::dvec3> points;
  points.reserve(places.size());
  for (const Place& p : places) points.push_back(rounded(p));
  return points;
}
[[nodiscard]] inline Shadow length(const Place& v) { return sqrt(dot(v, v)); }
/// Of length 1; 0 stays 0.
[[nodiscard]] inline Place unit(const Place& v) {
  const Shadow size = length(v);
  return size == 0 ? v : Place{v.x / size, v.y / size, v.z / size};
}
/// A unit vector at right angles to a unit vector.
[[nodiscard]] inline Place some_perpendicular(const Place& v) {
  const bool is_along_z = abs(v.x) < Shadow(0.5) && abs(v.y) < Shadow(0.5);
  return unit(cross(v, is_along_z ? Place{1, 0, 0} : Place{0, 0, 1}));
}

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

/// A line that a ray must pass by to change its verdict: an edge, a rim, the line of a round side that is
/// nearest the ray.
struct Border {
  std::array<Place, 2> line;
  /// From the line into each face that meets in it, at right angles to it; none where the surface is round.
  std::vector<Place> into{};
};

/// A shape in the world: a polygon (one face), a convex solid (several), or an ellipsoid (none).
struct Figure {
  std::vector<Place> points{};                    ///< the corners; of an ellipsoid the tips of its axes
  std::vector<std::vector<std::size_t>> faces{};  ///< the corners around each
  std::vector<Place> ellipsoid{};                 ///< its centre and the tips of three conjugate semi-axes
  std::vector<std::vector<Place>> grid{};         ///< lines on the surface that help the eye
  std::vector<Place> normals{};  ///< unit normals of the surfaces that ought not to be seen edge-on
  std::vector<std::pair<std::string, Place>> labels{};
  std::vector<Border> borders{};
};

/// The polygon of the vertices in order. `normal` need not be of unit length; `names` are the first
/// vertices'.
[[nodiscard]] Figure flat_figure(const std::vector<Place>& vertices, const Place& normal,
                                 const std::vector<std::string>& names);

/// A box or parallelepiped. Edges of length 0 are allowed.
[[nodiscard]] Figure solid_figure(const Place& corner, const std::array<Place, 3>& edges);

struct RayScene {
  Sight sight;
  Figure figure;
  Place along_ray;  ///< the direction, of unit length

  [[nodiscard]] Place at(const Shadow& t) const { return point_at(sight.ray, t); }
  [[nodiscard]] StageCamera camera() const;
};
[[nodiscard]] RayScene scene_of(const Case& one, const Answer* exact, const Answer* claimed);

struct NearestPass {
  const Border* border;  ///< of the scene's figure
  Shadow t;
  Place on_outline;
  Shadow gap;
};
[[nodiscard]] std::optional<NearestPass> nearest_of(const RayScene& scene);

/// From where neither the ray is seen end-on nor a surface with one of the given normals edge-on; the ray
/// runs to the right. All are unit vectors.
[[nodiscard]] StageCamera chosen_camera(const glm::dvec3& along_ray, const std::vector<glm::dvec3>& normals);

}  // namespace rayproof::viz
