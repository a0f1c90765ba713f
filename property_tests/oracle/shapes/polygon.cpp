/// \file
/// The oracle for ray and polygon.

#include "oracle/geometry/newell.hpp"
#include "oracle/shapes/outlined.hpp"
#include "oracle/shapes/shapes.hpp"

namespace rayproof::oracle {
namespace {

class PolygonIntersection final : public OutlinedIntersection {
 public:
  PolygonIntersection(const RayQuestion& question, const Polygon<double>& polygon)
      : OutlinedIntersection(question, plane_through(polygon.vertices.front(), newell_normal<Ring>(polygon))),
        polygon_(polygon) {}

  /// In units of what the rounding of the normal moves.
  [[nodiscard]] Scaled margin(bool may_merge) const override {
    const Scaled nearest = OutlinedIntersection::margin(may_merge);
    if (is_degenerate()) return nearest;
    return nearest / std::max(Scaled(1), reach() * reach() / norm(plane_normal()));
  }

 protected:
  [[nodiscard]] std::span<const glm::dvec3> corners() const override { return polygon_.vertices; }
  [[nodiscard]] Contact contact_at(const Quotient& t) const override {
    return located(t.denominator() * ray().origin + t.numerator() * ray().direction, t.denominator());
  }

  /// The sum of the products that Newell's normal is made of.
  [[nodiscard]] std::array<Scaled, 3> normal_sizes() const override {
    Scaled sum;
    const glm::dvec3* from = &corners().back();
    for (const glm::dvec3& to : corners()) {
      sum = sum + norm(*from) * norm(to);
      from = &to;
    }
    return {sum};
  }
  /// As large as seen from any of its vertices.
  [[nodiscard]] Scaled size_of_products() const override {
    return Scaled(static_cast<double>(polygon_.vertices.size())) * reach() * reach();
  }

 private:
  /// The largest distance of a vertex from the first.
  [[nodiscard]] Scaled reach() const {
    const auto first = Vector<Ring>::from(polygon_.vertices.front());
    Scaled farthest;
    for (const glm::dvec3& vertex : polygon_.vertices)
      farthest = std::max(farthest, norm(Vector<Ring>::from(vertex) - first));
    return farthest;
  }

  const Polygon<double>& polygon_;
};

}  // namespace

ExactPointer intersection_of(const RayQuestion& question, const Polygon<double>& polygon) {
  return std::make_unique<PolygonIntersection>(question, polygon);
}

}  // namespace rayproof::oracle
