/// \file
/// The oracle for ray and triangle.

#include <algorithm>

#include "oracle/shapes/outlined.hpp"
#include "oracle/shapes/shapes.hpp"

namespace rayproof::oracle {
namespace {

/// With (b-a)×(c-a) as its normal; a zero normal where the area is zero.
FlatEquation plane_of(const Triangle<double>& triangle) {
  const auto a = Vector<Ring>::from(triangle.a);
  return plane_through(triangle.a,
                       cross(Vector<Ring>::from(triangle.b) - a, Vector<Ring>::from(triangle.c) - a));
}

/// The signed volumes that the ray's direction spans with each edge as seen from the origin. Over their sum
/// they are the barycentric coordinates of the point in which the line meets the triangle's plane.
std::array<Ring, 3> volumes_of(const ObjectRay<Ring>& ray, const Triangle<double>& triangle) {
  const auto seen = [&](const glm::dvec3& v) { return ray.scaled(Vector<Ring>::from(v)) - ray.origin; };
  const Vector<Ring> a = seen(triangle.a), b = seen(triangle.b), c = seen(triangle.c);
  return {dot(ray.direction, cross(b, c)), dot(ray.direction, cross(c, a)), dot(ray.direction, cross(a, b))};
}

class TriangleIntersection final : public OutlinedIntersection {
 public:
  TriangleIntersection(const RayQuestion& question, const Triangle<double>& triangle)
      : OutlinedIntersection(question, plane_of(triangle)),
        corners_{triangle.a, triangle.b, triangle.c},
        volumes_(volumes_of(ray(), triangle)) {}

  [[nodiscard]] std::optional<std::array<Quotient, 3>> barycentric() const override {
    if (sign(sum()) == 0) return std::nullopt;  // parallel to its plane
    const auto weight = [whole = sum()](const Ring& volume) { return Quotient(volume, whole); };
    return std::array{weight(volumes_[0]), weight(volumes_[1]), weight(volumes_[2])};
  }

  /// 1 over the steepness.
  [[nodiscard]] double far() const override { return 1 / value(steepness()); }
  /// How large the volumes may be over their sum, with the vertices as far from the origin as they are; under
  /// a transform as far as its rounding may put them.
  [[nodiscard]] Scaled condition_of_coordinates(const Scaled& /*roundoff*/) const override {
    const Scaled scale = approximate(ray().scale);
    const auto apart = [&](const glm::dvec3& v) {
      return ray().map ? scale * sizes().origin : norm(Vector<Ring>::from(v) - ray().origin);
    };
    const Scaled reach = std::max({apart(corners_[0]), apart(corners_[1]), apart(corners_[2])});
    return Scaled(1) + reach * reach * scale * sizes().direction / abs(approximate(sum()));
  }

 protected:
  [[nodiscard]] std::span<const glm::dvec3> corners() const override { return corners_; }
  [[nodiscard]] Contact contact_at(const Quotient&) const override {
    const int whole = sign(sum());
    int on_sides = 0;
    for (const Ring& volume : volumes_) {
      const int side = sign(volume) * whole;
      if (side < 0) return Contact::none;
      if (side == 0) ++on_sides;
    }
    return on_sides == 2 ? Contact::vertex : on_sides == 1 ? Contact::edge : Contact::crossing;
  }

  /// The product of the two longest edges.
  [[nodiscard]] std::array<Scaled, 3> normal_sizes() const override {
    const auto edge = [](const glm::dvec3& from, const glm::dvec3& to) {
      return norm(Vector<Ring>::from(to) - Vector<Ring>::from(from));
    };
    std::array<Scaled, 3> edges{edge(corners_[0], corners_[1]), edge(corners_[1], corners_[2]),
                                edge(corners_[2], corners_[0])};
    std::ranges::sort(edges, [](const Scaled& x, const Scaled& y) { return x < y; });
    return {edges[1] * edges[2]};
  }

 private:
  [[nodiscard]] Ring sum() const { return volumes_[0] + volumes_[1] + volumes_[2]; }

  std::array<glm::dvec3, 3> corners_;
  std::array<Ring, 3> volumes_;
};

}  // namespace

ExactPointer intersection_of(const RayQuestion& question, const Triangle<double>& triangle) {
  return std::make_unique<TriangleIntersection>(question, triangle);
}

}  // namespace rayproof::oracle
