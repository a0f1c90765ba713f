/// \file
/// The oracle for point in polygon.

#include "oracle/geometry/locate.hpp"
#include "oracle/geometry/sizes.hpp"
#include "oracle/judge/judging.hpp"
#include "oracle/shapes/shapes.hpp"

namespace rayproof::oracle {
namespace {

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

Position answer(const PointAndPolygon<double>& question, Precision) {
  std::vector<PlanePoint> vertices;
  vertices.reserve(question.vertices.size());
  for (const auto& vertex : question.vertices) vertices.push_back({Ring(vertex.x), Ring(vertex.y)});
  const Contact contact = locate({Ring(question.point.x), Ring(question.point.y)}, Ring(1.0), vertices);
  if (contact == Contact::crossing) return Position::inside;
  return contact == Contact::none ? Position::outside : Position::boundary;
}

Judgement judge(const PointAndPolygon<double>& question, Precision precision, Position claimed) {
  const Position exact = answer(question, precision);
  Judgement judgement;
  note_range(judgement, question.point, question.vertices);
  judgement.hit = exact != Position::outside;
  judgement.wrong = claimed != exact;
  if (judgement.wrong) {
    judgement.ulp = std::nan("");
    judgement.margin = in_units(margin_of(question), precision);
  }
  return judgement;
}

}  // namespace rayproof::oracle
