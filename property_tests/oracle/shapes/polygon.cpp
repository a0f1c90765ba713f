/// \file
/// The oracle for ray and polygon.

#include "oracle/shapes/estimated.hpp"
#include "oracle/shapes/flat_meeting.hpp"
#include "oracle/shapes/outlined.hpp"
#include "oracle/shapes/shapes.hpp"

namespace rayproof::oracle {
namespace {

/// How the line touches the polygon where it meets its plane at t, as the projection sees it.
template <class R>
Contact contact_of(const QuotientOf<R>& t, const Projection<R>& project, const ObjectRay<R>& ray,
                   const Polygon<double>& polygon) {
  const Vector<R> point = t.denominator() * ray.origin + t.numerator() * ray.direction;
  return locate_in_outline(point, t.denominator(), project, ray, std::span(polygon.vertices));
}

/// By how much more a sum over this many vertices is off: each product is rounded with what is before it.
double length_of_sum(std::size_t vertices) { return std::max(1.0, static_cast<double>(vertices) / 64); }

/// The sum of the products that Newell's normal is made of.
template <class Size>
Size normal_size_of(const Polygon<double>& polygon) {
  Size sum{};
  Size from(length_of(polygon.vertices.back()));
  for (const glm::dvec3& vertex : polygon.vertices) {
    const Size to(length_of(vertex));
    sum = sum + from * to;
    from = to;
  }
  return sum * Size(length_of_sum(polygon.vertices.size()));
}

/// As the quick judge sees it.
class PolygonMeeting : public FlatMeeting {
 public:
  PolygonMeeting(const RayQuestion& question, const Polygon<double>& polygon)
      : FlatMeeting(question, equation_of<Estimate>(polygon)), polygon_(polygon) {}

  [[nodiscard]] auto hits() const {
    return hits_where(
        [&](const auto& t) { return contact_of(t, Projection(met().normal), ray(), polygon_); });
  }
  void measure() { measure_by(farthest_of(polygon_.vertices), normal_size_of<long double>(polygon_)); }
  [[nodiscard]] double far() const { return 1; }

 private:
  const Polygon<double>& polygon_;
};

class PolygonIntersection final : public OutlinedIntersection {
 public:
  PolygonIntersection(const RayQuestion& question, const Polygon<double>& polygon)
      : OutlinedIntersection(question, equation_of<Ring>(polygon)), polygon_(polygon) {}

  /// In units of what the rounding of the normal moves, or by how little another axis of the projection was
  /// not chosen.
  [[nodiscard]] Scaled margin(bool may_merge) const override {
    Scaled nearest = OutlinedIntersection::margin(may_merge);
    if (is_degenerate()) return nearest;
    nearest = nearest / std::max(Scaled(1), reach() * reach() / norm(plane_normal()));
    for (const int axis : {0, 1, 2}) reduce(nearest, lead_over(axis));
    return nearest;
  }

 protected:
  [[nodiscard]] std::span<const glm::dvec3> corners() const override { return polygon_.vertices; }
  [[nodiscard]] Contact contact_at(const Quotient& t) const override {
    return contact_of(t, Projection(plane_normal()), ray(), polygon_);
  }

  [[nodiscard]] std::array<Scaled, 3> normal_sizes() const override {
    return {normal_size_of<Scaled>(polygon_)};
  }
  /// As large as seen from any of its vertices.
  [[nodiscard]] Scaled size_of_products() const override {
    const std::size_t count = polygon_.vertices.size();
    return Scaled(static_cast<double>(count) * length_of_sum(count)) * reach() * reach();
  }

 private:
  /// How much larger the normal's largest component is than the axis's, in units of what moving each vertex
  /// by its own length would make of it; endless where the polygon, seen along the axis, is met all the same.
  [[nodiscard]] Scaled lead_over(int axis) const {
    if (is_parallel()) return endless();
    const Vector<Ring>& normal = plane_normal();
    const Projection<Ring> chosen(normal), other(axis);
    const auto is_met = [&](const Projection<Ring>& project) {
      return contact_of(t(), project, ray(), polygon_) != Contact::none;
    };
    if (is_met(chosen) == is_met(other)) return endless();
    const Scaled lead = abs(approximate(normal[chosen.axis()])) - abs(approximate(normal[axis]));
    Scaled lengths;
    for (const glm::dvec3& vertex : polygon_.vertices) lengths = lengths + norm(vertex);
    return lead / (reach() * lengths);
  }
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

Judgement judge(const RayQuestion& question, const Polygon<double>& polygon, Precision precision,
                const RayAnswer& claimed) {
  return judge_quickly<PolygonMeeting>(question, polygon, precision, claimed);
}

}  // namespace rayproof::oracle
