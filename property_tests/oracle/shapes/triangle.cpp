/// \file
/// The oracle for ray and triangle.

#include <algorithm>

#include "oracle/shapes/estimated.hpp"
#include "oracle/shapes/flat_meeting.hpp"
#include "oracle/shapes/outlined.hpp"
#include "oracle/shapes/shapes.hpp"

namespace rayproof::oracle {
namespace {

/// The signed volumes that the ray's direction spans with each edge as seen from the origin. Over their sum
/// they are the barycentric coordinates of the point in which the line meets the triangle's plane.
template <class R>
std::array<R, 3> volumes_of(const ObjectRay<R>& ray, const Triangle<double>& triangle) {
  const auto seen = [&](const glm::dvec3& v) { return ray.scaled(Vector<R>::from(v)) - ray.origin; };
  const Vector<R> a = seen(triangle.a), b = seen(triangle.b), c = seen(triangle.c);
  return {dot(ray.direction, cross(b, c)), dot(ray.direction, cross(c, a)), dot(ray.direction, cross(a, b))};
}

/// How the line touches the triangle.
template <class R>
Contact contact_of(const std::array<R, 3>& volumes) {
  const int whole = sign(volumes[0] + volumes[1] + volumes[2]);
  int on_sides = 0;
  for (const R& volume : volumes) {
    const int side = sign(volume) * whole;
    if (side < 0) return Contact::none;
    if (side == 0) ++on_sides;
  }
  return on_sides == 2 ? Contact::vertex : on_sides == 1 ? Contact::edge : Contact::crossing;
}

/// The product of the two longest edges.
template <class R>
SizeOf<R> normal_size_of(const Triangle<double>& triangle) {
  const auto edge = [](const glm::dvec3& from, const glm::dvec3& to) {
    return length_of(step_between<R>(from, to));
  };
  const SizeOf<R> ab = edge(triangle.a, triangle.b), bc = edge(triangle.b, triangle.c),
                  ca = edge(triangle.c, triangle.a);
  return std::max(ab, bc) * std::max(std::min(ab, bc), ca);
}

/// 1 over the steepness. Of a triangle with no edge from a it is 1: its normal is 0 in rounded numbers, too,
/// and no digit of it is lost.
template <class Size>
double far_of(const Triangle<double>& triangle, const Size& steepness) {
  return triangle.b == triangle.a || triangle.c == triangle.a ? 1 : value(1 / steepness);
}

/// As the quick judge sees it.
class TriangleMeeting : public FlatMeeting {
 public:
  TriangleMeeting(const RayQuestion& question, const Triangle<double>& triangle)
      : FlatMeeting(question, equation_of<Estimate>(triangle)), triangle_(triangle) {}

  [[nodiscard]] auto hits() const {
    return hits_where([&](const auto& /*t*/) { return contact_of(volumes_of(ray(), triangle_)); });
  }
  void measure() {
    const long double position =
        std::max({length_of(triangle_.a), length_of(triangle_.b), length_of(triangle_.c)});
    measure_by(position, normal_size_of<Estimate>(triangle_));
  }
  [[nodiscard]] double far() const { return far_of(triangle_, steepness_of(met(), sizes())); }

 private:
  const Triangle<double>& triangle_;
};

class TriangleIntersection final : public OutlinedIntersection {
 public:
  TriangleIntersection(const RayQuestion& question, const Triangle<double>& triangle)
      : OutlinedIntersection(question, equation_of<Ring>(triangle)),
        corners_{triangle.a, triangle.b, triangle.c},
        volumes_(volumes_of(ray(), triangle)) {}

  [[nodiscard]] std::optional<std::array<Quotient, 3>> barycentric() const override {
    if (sign(sum()) == 0) return std::nullopt;  // parallel to its plane
    const auto weight = [whole = sum()](const Ring& volume) { return Quotient(volume, whole); };
    return std::array{weight(volumes_[0]), weight(volumes_[1]), weight(volumes_[2])};
  }

  [[nodiscard]] double far() const override {
    return far_of({corners_[0], corners_[1], corners_[2]}, steepness());
  }
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
  [[nodiscard]] Contact contact_at(const Quotient&) const override { return contact_of(volumes_); }
  [[nodiscard]] std::array<Scaled, 3> normal_sizes() const override {
    return {normal_size_of<Ring>({corners_[0], corners_[1], corners_[2]})};
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

Judgement judge(const RayQuestion& question, const Triangle<double>& triangle, Precision precision,
                const RayAnswer& claimed) {
  return judge_quickly<TriangleMeeting>(question, triangle, precision, claimed);
}

}  // namespace rayproof::oracle
