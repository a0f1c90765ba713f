/// \file
/// The oracle for point in polygon.

#include "oracle/geometry/locate.hpp"
#include "oracle/geometry/sizes.hpp"
#include "oracle/judge/judging.hpp"
#include "oracle/shapes/shapes.hpp"

namespace rayproof::oracle {
namespace {

/// A point of the plane in exact numbers.
PlanePoint exactly(const Vec2<double>& v) { return {Ring(v.x), Ring(v.y)}; }

std::vector<PlanePoint> exactly(const std::vector<Vec2<double>>& vertices) {
  std::vector<PlanePoint> points;
  points.reserve(vertices.size());
  for (const auto& vertex : vertices) points.push_back(exactly(vertex));
  return points;
}

/// The distance of the point from the nearest side in units of |point| + P.
Scaled margin_of(const PointAndPolygon<double>& question) {
  const auto length = [](const Vec2<double>& v) { return norm(glm::dvec3(v.x, v.y, 0)); };
  Scaled farthest, nearest = endless();
  for (const auto& vertex : question.vertices) farthest = std::max(farthest, length(vertex));
  const Scaled reach = length(question.point) + farthest;
  const PlanePoint point = exactly(question.point);
  const std::vector<PlanePoint> vertices = exactly(question.vertices);
  for (std::size_t i = 0; i < vertices.size(); ++i)
    reduce(
        nearest,
        ratio(distance_to_side(point, Ring(1.0), vertices[i], vertices[(i + 1) % vertices.size()]), reach));
  return nearest;
}

}  // namespace

Position answer(const PointAndPolygon<double>& question, Precision) {
  const Contact contact = locate(exactly(question.point), Ring(1.0), exactly(question.vertices));
  if (contact == Contact::crossing) return Position::inside;
  return contact == Contact::none ? Position::outside : Position::boundary;
}

Judgement judge(const PointAndPolygon<double>& question, Precision precision, Position claimed) {
  const Position exact = answer(question, precision);
  Judgement judgement;
  Magnitudes lengths;
  lengths.note(question.point);
  lengths.note(question.vertices);
  lengths.put(judgement);
  judgement.hit = exact != Position::outside;
  judgement.wrong = claimed != exact;
  if (judgement.wrong) {
    judgement.ulp = std::nan("");
    judgement.margin = exact == Position::boundary ? 0 : in_units(margin_of(question), precision);
  }
  return judgement;
}

}  // namespace rayproof::oracle
