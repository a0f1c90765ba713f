/// \file
/// The judges for polygons, met by rays and holding points.

#include <algorithm>

#include "oracle/geometry/polygon_plane.hpp"
#include "oracle/judge/flat_judge.hpp"
#include "oracle/shapes/polygon.hpp"

namespace rayproof::oracle {
namespace {

/// Where a number lies between 0 and 1.
Scaled clamped(const Scaled& x) {
  if (x.sign() < 0) return {};
  return Scaled(1) < x ? Scaled(1) : x;
}

/// The distance of the point from the side, all to one part in 2^50.
Scaled distance_to_side(const PlanePoint& point, const Ring& weight, const PlanePoint& from,
                        const PlanePoint& to) {
  const Scaled x = approximate(point.x - weight * from.x), y = approximate(point.y - weight * from.y);
  const Scaled along_x = approximate(to.x - from.x), along_y = approximate(to.y - from.y);
  const Scaled scale = approximate(weight);
  const Scaled squared = along_x * along_x + along_y * along_y;
  const Scaled share =
      squared.sign() == 0 ? Scaled{} : clamped((x * along_x + y * along_y) / (squared * scale));
  const Scaled dx = x / scale - share * along_x, dy = y / scale - share * along_y;
  return sqrt(dx * dx + dy * dy);
}

class PolygonFigure final : public FlatFigure {
 public:
  PolygonFigure(const RayQuestion& question, const Polygon<double>& polygon)
      : PolygonFigure(question, polygon, plane_of(polygon)) {}

  [[nodiscard]] Scaled margin() const override {
    Scaled nearest = FlatFigure::margin();
    reduce(nearest, steepness());
    if (meeting().is_parallel()) return nearest;
    const auto [point, weight] = meeting_point();
    const Scaled unit = reach(meeting().t().estimate()) / steepness();
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      const PlanePoint& from = vertices_[i];
      const PlanePoint& to = vertices_[(i + 1) % vertices_.size()];
      reduce(nearest, ratio(distance_to_side(point, weight, from, to), unit));
    }
    return nearest;
  }

 protected:
  [[nodiscard]] bool holds_meeting() const override {
    const auto [point, weight] = meeting_point();
    return locate(point, weight, vertices_) != Place::outside;
  }

 private:
  PolygonFigure(const RayQuestion& question, const Polygon<double>& polygon, const FlatEquation& plane)
      : FlatFigure(question, plane, size_of(polygon), distance(polygon)),
        projection_(plane.normal),
        vertices_(projected(polygon, projection_)) {}

  /// The point in which the line meets the plane, in the projection, times a positive weight.
  [[nodiscard]] std::pair<PlanePoint, Ring> meeting_point() const {
    const Quotient t = meeting().t();
    const Vector<Ring> point = t.denominator() * ray().origin + t.numerator() * ray().direction;
    const Ring weight = ray().scale * t.denominator();
    if (sign(weight) > 0) return {projection_(point), weight};
    return {projection_(Ring(-1.0) * point), -weight};
  }

  static Scaled size_of(const Polygon<double>& polygon) {
    Scaled sum;
    const glm::dvec3* from = &polygon.vertices.back();
    for (const glm::dvec3& to : polygon.vertices) {
      sum = sum + norm(*from) * norm(to);
      from = &to;
    }
    return sum;
  }
  static Scaled distance(const Polygon<double>& polygon) {
    Scaled farthest;
    for (const glm::dvec3& vertex : polygon.vertices) farthest = std::max(farthest, norm(vertex));
    return farthest;
  }

  Projection projection_;
  std::vector<PlanePoint> vertices_;
};

/// The least |orientation| of the point and a side at its height, in units of (|point| + P)².
Scaled margin_of(const PointAndPolygon<double>& question) {
  const auto length = [](const Vec2<double>& v) { return norm(glm::dvec3(v.x, v.y, 0)); };
  Scaled farthest;
  for (const auto& vertex : question.vertices) farthest = std::max(farthest, length(vertex));
  const Scaled reach = length(question.point) + farthest;
  Scaled nearest = endless();
  const Ring x(question.point.x), y(question.point.y);
  const Vec2<double>* from = &question.vertices.back();
  for (const Vec2<double>& to : question.vertices) {
    if (std::min(from->y, to.y) <= question.point.y && question.point.y <= std::max(from->y, to.y)) {
      const Ring area = (Ring(from->x) - x) * (Ring(to.y) - y) - (Ring(from->y) - y) * (Ring(to.x) - x);
      reduce(nearest, ratio(abs(approximate(area)), reach * reach));
    }
    from = &to;
  }
  return nearest;
}

}  // namespace

Judgement judge(const RayQuestion& question, const Polygon<double>& polygon, Precision precision,
                const RayAnswer& claimed) {
  return judge_hits(question, PolygonFigure(question, polygon), precision, claimed);
}

Judgement judge(const PointAndPolygon<double>& question, Precision precision, Position claimed) {
  const Position exact = answer(question);
  Judgement judgement;
  std::vector<double> numbers{question.point.x, question.point.y};
  for (const auto& vertex : question.vertices) numbers.insert(numbers.end(), {vertex.x, vertex.y});
  note_range(numbers, judgement);
  judgement.hit = exact != Position::outside;
  judgement.wrong = claimed != exact;
  if (judgement.wrong) {
    judgement.ulp = std::nan("");
    judgement.margin = static_cast<double>((margin_of(question) / Scaled(unit_roundoff(precision))).value());
  }
  return judgement;
}

}  // namespace rayproof::oracle
