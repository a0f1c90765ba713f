/// \file
/// The oracle for ray and triangle.

#include <algorithm>

#include "oracle/shapes/flat.hpp"
#include "oracle/shapes/shapes.hpp"

namespace rayproof::oracle {
namespace {

/// With (b-a)×(c-a) as its normal; a zero normal where the area is zero.
FlatEquation plane_of(const Triangle<double>& triangle) {
  const auto a = Vector<Ring>::from(triangle.a);
  return plane_through(triangle.a,
                       cross(Vector<Ring>::from(triangle.b) - a, Vector<Ring>::from(triangle.c) - a));
}

class TriangleIntersection final : public FlatIntersection {
 public:
  TriangleIntersection(const RayQuestion& question, const Triangle<double>& triangle)
      : FlatIntersection(question, plane_of(triangle)), triangle_(triangle) {
    const auto seen = [&](const glm::dvec3& vertex) {
      return ray().scale * Vector<Ring>::from(vertex) - ray().origin;
    };
    const Vector<Ring> to_a = seen(triangle.a), to_b = seen(triangle.b), to_c = seen(triangle.c);
    volumes_ = {dot(ray().direction, cross(to_b, to_c)), dot(ray().direction, cross(to_c, to_a)),
                dot(ray().direction, cross(to_a, to_b))};
  }

  [[nodiscard]] std::optional<std::array<Quotient, 3>> barycentric() const override {
    const auto weight = [&](const Ring& volume) { return Quotient(volume, sum()); };
    return std::array{weight(volumes_[0]), weight(volumes_[1]), weight(volumes_[2])};
  }

  [[nodiscard]] Scaled margin() const override {
    Scaled nearest = FlatIntersection::margin();
    reduce(nearest, steepness());
    const Scaled scale = approximate(ray().scale), length = sizes().origin;
    const Scaled unit = scale * scale * scale * length * length * sizes().direction;
    for (const Ring& volume : volumes_) reduce(nearest, ratio(abs(approximate(volume)), unit));
    return nearest;
  }

 protected:
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

  [[nodiscard]] Scaled position() const override {
    return std::max({norm(triangle_.a), norm(triangle_.b), norm(triangle_.c)});
  }
  /// The product of the two longest edges.
  [[nodiscard]] std::array<Scaled, 3> normal_sizes() const override {
    const auto edge = [](const glm::dvec3& from, const glm::dvec3& to) {
      return norm(Vector<Ring>::from(to) - Vector<Ring>::from(from));
    };
    std::array<Scaled, 3> edges{edge(triangle_.a, triangle_.b), edge(triangle_.b, triangle_.c),
                                edge(triangle_.c, triangle_.a)};
    std::ranges::sort(edges, [](const Scaled& x, const Scaled& y) { return x < y; });
    return {edges[1] * edges[2]};
  }

 private:
  [[nodiscard]] Ring sum() const { return volumes_[0] + volumes_[1] + volumes_[2]; }

  const Triangle<double>& triangle_;
  /// The signed volumes that the ray's direction spans with each edge as seen from the origin. Over their sum
  /// they are the barycentric coordinates of the point in which the line meets the triangle's plane.
  std::array<Ring, 3> volumes_;
};

}  // namespace

std::unique_ptr<MeasuredIntersection> intersection_of(const RayQuestion& question,
                                                      const Triangle<double>& triangle) {
  return std::make_unique<TriangleIntersection>(question, triangle);
}

}  // namespace rayproof::oracle
